// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/furniture/piece.h"
#include "renderer_worker/furniture/rest_height.h"

// The makers of furniture, one function each, by family; make_piece.cc says which class takes which. Each fills its
// box, about: the piece is stretched to it in the end.
namespace flair::renderer {

// seating.cc
void MakeSofa(Piece& p);
void MakeArmchair(Piece& p);
void MakeDaybed(Piece& p);
void MakePouf(Piece& p);
void MakeBeanBag(Piece& p);

// chairs.cc
void MakeChair(Piece& p);
void MakeOfficeChair(Piece& p);
void MakeRockingChair(Piece& p);
void MakeStool(Piece& p);
void MakeBench(Piece& p);
void MakeThrone(Piece& p);

// beds.cc
void MakeBed(Piece& p);
void MakeBunkBed(Piece& p);
void MakeCot(Piece& p);
void MakeCoffin(Piece& p);

// tables.cc
void MakeTable(Piece& p);
void MakeRoundTable(Piece& p);
void MakeCoffeeTable(Piece& p);
void MakeSideTable(Piece& p);
void MakeNightstand(Piece& p);
void MakeDesk(Piece& p);
void MakeVanity(Piece& p);
void MakeWorkbench(Piece& p);
void MakePoolTable(Piece& p);

// storage.cc
void MakeWardrobe(Piece& p);
void MakeDresser(Piece& p);
void MakeTvStand(Piece& p);
void MakeCabinet(Piece& p);
void MakeBookshelf(Piece& p);
void MakeShelf(Piece& p);

// containers.cc
void MakeTrunk(Piece& p);
void MakeBarrel(Piece& p);
void MakeBasket(Piece& p);
void MakeCoatStand(Piece& p);
void MakeGarmentRack(Piece& p);
void MakeRack(Piece& p);
void MakeLadder(Piece& p);
void MakeFoldingScreen(Piece& p);

// kitchen.cc
void MakeCounter(Piece& p);
void MakeKitchenIsland(Piece& p);
void MakeSink(Piece& p);
void MakeHob(Piece& p);
void MakeFridge(Piece& p);
void MakeWashingMachine(Piece& p);
void MakeDishwasher(Piece& p);
void MakeSmallAppliance(Piece& p);
void MakeRangeHood(Piece& p);

// bathroom.cc
void MakeBath(Piece& p);
void MakePool(Piece& p);
void MakeShower(Piece& p);
void MakeToilet(Piece& p);
void MakeBasin(Piece& p);

// hearth.cc
void MakeCauldron(Piece& p);
void MakeFireplace(Piece& p);
void MakeAquarium(Piece& p);
void MakeLogStack(Piece& p);
void MakeCart(Piece& p);
void MakeOrganizer(Piece& p);
void MakeBox(Piece& p);

// music.cc
void MakeUprightPiano(Piece& p);
void MakeGrandPiano(Piece& p);
void MakeKeyboard(Piece& p);
void MakeDrums(Piece& p);
void MakeGuitar(Piece& p);
void MakeMusicStand(Piece& p);
void MakeSpeaker(Piece& p);

// sport.cc
void MakeTreadmill(Piece& p);
void MakeExerciseBike(Piece& p);
void MakeRowingMachine(Piece& p);
void MakeWeightBench(Piece& p);
void MakeWeights(Piece& p);
void MakePunchingBag(Piece& p);

// craft.cc
void MakeEasel(Piece& p);
void MakeSewingMachine(Piece& p);
void MakeMannequin(Piece& p);
void MakeIroningBoard(Piece& p);
void MakeLoom(Piece& p);
void MakeSpinningWheel(Piece& p);
void MakeTelescope(Piece& p);
void MakeGlobe(Piece& p);

// plants.cc
void MakePlant(Piece& p);

// decor.cc
void MakeVase(Piece& p);
void MakeTray(Piece& p);
void MakeBooks(Piece& p);
void MakeCandles(Piece& p);

// figures.cc
void MakeOrb(Piece& p);
void MakeStatue(Piece& p);
void MakeToy(Piece& p);
void MakeTent(Piece& p);

// lamps.cc
void MakeFloorLamp(Piece& p);
void MakeTableLamp(Piece& p);
void MakeWallLamp(Piece& p);
void MakePendant(Piece& p);
void MakeChandelier(Piece& p);

// textiles.cc
void MakeRug(Piece& p);
void MakeRoundRug(Piece& p);
void MakeMat(Piece& p);
void MakeCushion(Piece& p);
void MakeBlanket(Piece& p);
void MakeCurtain(Piece& p);

// mounted.cc
void MakePicture(Piece& p);
void MakeMirror(Piece& p);
void MakeClock(Piece& p);
void MakeBoard(Piece& p);
void MakeTelevision(Piece& p);
void MakeScreen(Piece& p);
void MakeLaptop(Piece& p);
void MakeCeilingFan(Piece& p);

}  // namespace flair::renderer
