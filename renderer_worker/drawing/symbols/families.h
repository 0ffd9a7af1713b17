// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/drawing/symbols/symbol.h"

// The plan symbols, one function each, by family. symbol_table.cc says which category takes which.
namespace flair::renderer {

// beds.cc
void DrawBed(SymbolPen& pen);
void DrawBunkBed(SymbolPen& pen);
void DrawCot(SymbolPen& pen);
void DrawCoffin(SymbolPen& pen);
void DrawDaybed(SymbolPen& pen);

// seating.cc
void DrawSofa(SymbolPen& pen);
void DrawArmchair(SymbolPen& pen);
void DrawChair(SymbolPen& pen);
void DrawOfficeChair(SymbolPen& pen);
void DrawRockingChair(SymbolPen& pen);
void DrawStool(SymbolPen& pen);
void DrawBench(SymbolPen& pen);
void DrawPouf(SymbolPen& pen);
void DrawThrone(SymbolPen& pen);

// tables.cc
void DrawTable(SymbolPen& pen);
void DrawRoundTable(SymbolPen& pen);
void DrawCoffeeTable(SymbolPen& pen);
void DrawNightstand(SymbolPen& pen);
void DrawDesk(SymbolPen& pen);
void DrawVanity(SymbolPen& pen);
void DrawWorkbench(SymbolPen& pen);
void DrawPoolTable(SymbolPen& pen);

// storage.cc
void DrawWardrobe(SymbolPen& pen);
void DrawDresser(SymbolPen& pen);
void DrawCabinet(SymbolPen& pen);
void DrawBookshelf(SymbolPen& pen);
void DrawShelf(SymbolPen& pen);
void DrawRack(SymbolPen& pen);
void DrawTrunk(SymbolPen& pen);
void DrawBarrel(SymbolPen& pen);
void DrawBasket(SymbolPen& pen);

// kitchen.cc
void DrawCounter(SymbolPen& pen);
void DrawKitchenSink(SymbolPen& pen);
void DrawHob(SymbolPen& pen);
void DrawFridge(SymbolPen& pen);
void DrawWasher(SymbolPen& pen);
void DrawDishwasher(SymbolPen& pen);
void DrawCauldron(SymbolPen& pen);
void DrawFireplace(SymbolPen& pen);
void DrawSmallAppliance(SymbolPen& pen);

// bathroom.cc
void DrawBath(SymbolPen& pen);
void DrawShower(SymbolPen& pen);
void DrawToilet(SymbolPen& pen);
void DrawBasin(SymbolPen& pen);

// leisure.cc
void DrawUprightPiano(SymbolPen& pen);
void DrawGrandPiano(SymbolPen& pen);
void DrawKeyboard(SymbolPen& pen);
void DrawDrums(SymbolPen& pen);
void DrawGuitar(SymbolPen& pen);
void DrawMusicStand(SymbolPen& pen);
void DrawSpeaker(SymbolPen& pen);
void DrawTreadmill(SymbolPen& pen);
void DrawExerciseBike(SymbolPen& pen);
void DrawWeightBench(SymbolPen& pen);
void DrawWeights(SymbolPen& pen);

// craft.cc
void DrawEasel(SymbolPen& pen);
void DrawSewingMachine(SymbolPen& pen);
void DrawMannequin(SymbolPen& pen);
void DrawIroningBoard(SymbolPen& pen);
void DrawStatue(SymbolPen& pen);
void DrawTelescope(SymbolPen& pen);
void DrawGlobe(SymbolPen& pen);
void DrawTent(SymbolPen& pen);
void DrawToy(SymbolPen& pen);

// textiles.cc: rugs and mats
void DrawRug(SymbolPen& pen);
void DrawRoundRug(SymbolPen& pen);
void DrawMat(SymbolPen& pen);
void DrawCushion(SymbolPen& pen);

// decor.cc: what stands on furniture or beside it
void DrawPlant(SymbolPen& pen);
void DrawLamp(SymbolPen& pen);
void DrawScreen(SymbolPen& pen);
void DrawLaptop(SymbolPen& pen);
void DrawBooks(SymbolPen& pen);
void DrawVase(SymbolPen& pen);
void DrawTray(SymbolPen& pen);
void DrawCandles(SymbolPen& pen);
void DrawOrb(SymbolPen& pen);

// mounted.cc: what hangs on walls and from ceilings
void DrawPicture(SymbolPen& pen);
void DrawMirror(SymbolPen& pen);
void DrawCurtain(SymbolPen& pen);
void DrawTelevision(SymbolPen& pen);
void DrawWallLamp(SymbolPen& pen);
void DrawPendant(SymbolPen& pen);
void DrawChandelier(SymbolPen& pen);
void DrawCeilingFan(SymbolPen& pen);

// box.cc: anything else
void DrawPlainBox(SymbolPen& pen);

}  // namespace flair::renderer
