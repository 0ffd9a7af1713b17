// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/lexicon.h"

namespace flair::translator {

// One entry a line: "CLASS LEMMA: phrase | phrase ..."; [x] may be left out, (x|y) is either. A line that begins with a
// space continues the entry. The first entry wins when a phrase stands in two of the same length.
std::string_view LexiconEntries() {
  return R"(
filler: putting | setting | locating | installing | arranging | stationing | parking | fitting | neighbouring | neighboring | [evenly|equally] spaced [out] | end up | ends up | locating | situating | (guests|guest|visitors|visitor|customers|customer|clients|client|staff|occupants|occupant|children|child|kids|kid|adults|parents|family members|players|readers|viewers|viewer|engineer|somebody|everyone) | align | come | comes | at least | level with | people | someone | anyone | (the|a) (user|users|person|occupant|occupants) | being | (front|top) loading | at a [viewing|walking] (depth|width|radius|distance) of | [to|for] a depth of | [at|with] a spacing of | at (a|the) distance of | in (a|such a) (way|manner) (that|so that) [it|they] | such that (it|they) | allowed | given | considered | created | observed | (unobstructed|accessible|open|clear) (area|location|spot) | (an|a) accessible | check for | look for | align centrally | aligned centrally | if wall mounted | walk | walking | moving | to ensure (it|they) | maintained | ensured | provided | be left | is left | left over | when in use | any part of | accessibility | orientation | proportions | dimensions | some | least | somewhat | to be | allow for | allows for | allowing for | such that [it] | so that it | [in|at] [a|the|an|any] (position|positions|location|locations|spot|spots|place|places|area|areas|way|ways|manner|placement|placements|orientation) (where|that|which) [it|they] [will|would|could|might|can]
  | where (it|they) [will|would|could|might|can] | [at a|in a|at the] location | the | a | an | its own | own | this | these | those | there | be | being | been | have | has | having | had | such | as | then | also | both | just | only
  | place | places | placed | placing | placement | put | puts | set | sets | position | positions | positioned | positioning | locate | located | location | situate | situated | stand | stands | standing | sit | sits | sitting | keep | keeps | kept | keeping
  | leave | leaves | leaving | left free | ensure | ensures | ensuring | make sure | making sure | maintain | maintains | maintaining | provide | provides | providing | require | requires | requiring | need | needs | needed | allow | allows | arrange | arranged
  | arrangement | use | used | used for | lie | lies | lying | go | goes | run | runs | rest | rests | resting | remain | remains | stay | stays | consider | considering | consideration
  | enough | ample | adequate | sufficient | reasonable | comfortable | comfortably | good | easy | convenient | proper | clear | open | free | full | safe | suitable | appropriate | nice | total | overall
  | directly | immediately | fully | easily | slightly | frequently | frequently used | regularly | always | very | too | quite | at all | possible | well | exactly | right in
  | placement is | extra | additional | electrical | electric | gas | wall mounted power | standard | main | necessary | required | existing | available | specific | designated | entire | whole | main
  | small | large | big | tall | low | wide | wooden | round | rectangular | square | comfy | soft | long low | matching | same | adjoining | separate | respective | corresponding | certain | single | nearest | closest | immediate | outer | interior
  | able to | order | it is | way | out | somewhere | anywhere | approximately | about | roughly | minimum | maximum | min | max | every time
  | some of the | one of | all of the | accessible location | spot | surface space | do | does | did | get | gets | getting | eg | ie | physically | visually | typically | centrally aligned | facilitate
  | measuring | size | sized | (in|of) size | free of charge | still | yet | please | should the | together | aligned in | evenly | equally | symmetric | symmetrical | symmetrically | neatly
  | installed hanging | in position | in place | extends | extend | extending | centre on | floor level | placements | plenty of | between them and | other | of clearance
filler: (get|getting|climb|climbing|slip|slide) into
filler: outward | outwards | one without [a|any] (window|windows|door|doors|opening|openings|socket|sockets) | in the (open|free|empty|clear) (space|area|floor) | let | lets | letting | [the] (lower|upper|bottom|main|greater) (part|half|portion) of
filler: pushing | shoving | cramming | squeezing | forcing | (push|pushed|pushing|shove|shoved|shoving|move|moved|moving) up | belong | belongs | (on|by) (its|their) own | by (itself|themselves)
filler: (get|getting) (in|on) and (out|off) [of]
modal: (has|have|needs|need|ought) to be
modal: is to | are to | (should|must|can|may|shall|to|needs to|need to|has to|have to|ought to) be left | should | must | may | might | can | could | will | shall | is | are | needs to | need to | has to | have to | ought to | would | should be | must be | can be | is to be | are to be | may be | could be
wish: if one is (present|there|provided)
wish: if (any|applicable|present|they exist|it exists) | if available | if one is available | (if|where|when|provided) [the|your] (layout|space|room|design|plan|area) (permits|allows) [it] | if permitted | it is (recommended|advisable|best|preferable) (to|that) [have] | recommended | advisable | ideal to have | ideal to | ideally | preferably | if possible | where possible | when possible | if needed | if space allows | if space permits | if desired | possibly | optionally | perhaps | consider placing | it would be (nice|good) | prefer | prefers | preferable | better | best | likes to
  | where (space|room) (allows|permits) | (if|when|where) (feasible|practical|appropriate|suitable|convenient|allowed) | if it fits
  | (if|as long as|provided|provided that|so long as) (this|it|that|doing so) (does not|will not|would not) (violate|conflict with|contradict|affect|break|compromise|interfere with) [any] [of] [the] other (constraints|requirements|rules|needs|conditions|guidelines)
  | as far as possible | whenever possible | if there is (space|room)
purpose: (ensuring|allowing|providing|guaranteeing|facilitating) [for] (easy|smooth|free|good|convenient|comfortable|proper|movement|access|accessibility)
purpose: than | for | to | because | since | so that | which | who | while allowing | thus | thereby | due to | in order to | as it | as they | as this | allowing | enabling | giving | making | creating | to prevent | when | whilst | that | during | in case | acting as | serving as | especially | given | helping | adding | instead of | such as | like | depending | even
condition: [do|does] not (have|need) to
condition: not [necessarily] need to | need not | not necessarily | not (necessary|required|needed|essential) | is optional | no need | if | unless | only if | in the event
not: under no circumstances | in no case | no part of | on no account | at no time | by no means | in no way
not: rather than | (refrain|refrains|refraining) from | (take|taking) care not to | so as not to | not | nowhere | neither | hardly | no | avoid | avoids | avoiding | without | never | prevent | prevents | preventing | cannot | minimize | minimise | nor | none of | do not | neither | don
side front: [the] side (where|on which|at which) [the|a|one] (chair|user|person|stool|people|sits|stool) [goes|sits|sit|stands|is|are|will be] [placed|used] | [the] side with (the|its|their) (door|doors|drawer|drawers|shelves|screen|opening) | keyboard side
side front: front [side|edge|face|end|part] | front and center | foot [end] | footboard | fronts | front sides
side back: back [side|edge|end|part] | rear [side|edge] | headboard | head [end|side] | backrest | backs | back sides | headrest
side left: left [hand] (short|shorter|long|longer|narrow) (side|end|edge)
side left: left [hand] [side|edge|end] | left hand side
side right: right [hand] (short|shorter|long|longer|narrow) (side|end|edge)
side right: right [hand] [side|edge|end] | right hand side
side axial: both faces | both of its faces | front and (back|rear) [sides] | (back|rear) and front [sides]
side sides: arms | armrests | [both|the|two|either|each] sides | both [of its] sides | left and right [sides] | left and right side | (each|either) side | (left and right|right and left) sides | both ends | ends | lateral sides
side long_both: [two] (opposite|opposing) (long|longer) (sides|edges)
side short_both: [two] (opposite|opposing) (short|shorter) (sides|edges|ends)
side opposite_two: [on|at] [two] opposing sides
side opposite_two: [on|at] [at least] two opposite sides
side lateral_one: [either] [the|its] (left or right|right or left) side | [either] [the|its] (left or the right|right or the left) side
side side: [at least] one end | [at least] one (arm|end|lateral) side | (arm|lateral) side
side side: one or more sides | one or both sides | side | [the] (arm|armrest) | [at least] one side | [at least] one of [its|the] sides | (left or right|right or left) | a side | any side | at least one of its sides | one [free|open] side | one end
side sides: (either|each) (end|arm)
side back: tank | cistern | headboards | backrests | headrests | (tank|cistern|rear facing|wall) side
side front: front (legs|feet|half) | (player|customer|customers|guest|visitor|public|viewing|ladder|client) (side|end)
side three: [on|from|at] all [four] [of its] sides (except|but|besides|excluding|save|other than|apart from|except for|but for) [the|its] (back|rear|back side|rear side|wall side|one (against|at|facing) the wall)
side three: [on|from|at] (all|every) (side|sides) (but|except|save) [for] [the|its|one at the] (back|rear|wall) [side] | all but [the|its] (back|rear) [side]
side other: [the|its] (other|opposite|remaining) [long|short] side
side long_one: either [of the|of its] (long|longer|longest) (side|sides|edge|edges) | [at least|on] (one|a) [of its|of the|of their] (long|longer|longest|lengthwise) (side|sides|edge|edges) | (long|longer|longest) (side|edge) | (one|a) length
side long_both: [both] lengths | [both|the|two|on both|all] (long|longer|longest) (sides|edges)
side short_one: [at least] (one|a) [of its|of the] (short|shorter) (side|sides|edge|edges) | (short|shorter) (side|edge) | one width
side short_both: [both|the|two] (short|shorter) (sides|edges|ends)
side two_any: [at least] two adjacent sides | [at least|on at least] two [of its] sides
side three: [all|the] sides (not against|away from|not touching|not facing|facing away from|other than) [the|a|any] (wall|walls) | [all|the] sides that are not against [the|a|any] (wall|walls) | [at least] three [of its] sides
side all: (each|all|any) of (its|the) [four] sides | each and every side | all directions | every direction | all angles | all [of its|of the] [four] sides | all four sides | every side | all around sides | (each|all) of its sides | all [its] [four] sides
feature door: one with [a|the|any] (door|doors)
feature door: (room|bathroom|bedroom|kitchen|office|studio|building|house|bathhouse) (entry|entrance|exit|door|doorway|entryway) | (emergency|fire) (exit|exits|door|doors) | (egress|ingress) [point|points|route|routes] | (doors|door) swing (path|paths|arc|zone|radius) | entry (door|doors|zone|space|path|paths) | opening of [the] (door|doors) | (door|doors) (openings|entryways) | room 's (entrance|entry|door|doorway|exit) | (wall|walls) with [a|the] (door|doors) | [bedroom|entrance|entry|main|room|front] (door|doors|doorway|doorways) | [the] (entrance|entry|entryway|entryways|entrances|exit|exits|access point|entry point|entry points|doorframe|threshold) [door|way] | (door|door 's) (swing|swings|opening|area|clearance|path|frame|arc)
  | doors 's (swing|swings) | swing[ing] of [the] (door|doors) | swings | entry area | entrance area | doors swings | door swing area | passage door | entry to the room | entry and exit [points] | line of entry
feature window: one with [a|the|any] (window|windows)
feature window: (window|windows) access | opening of [the] (window|windows) | (wall|walls) with [a|the|any] (window|windows) | window (wall|walls) | window | windows | window light | window sill | windowsill | window opening | window area | bay window | natural light from [the] (window|windows) | source of natural light | natural light source | natural light
feature socket: wall power (outlet|outlets|socket|sockets|point|points)
feature socket: (plug|plug in|electricity|outlet) (point|points) | charging (point|points|station|stations) | (wall|power|electrical|electric) (plug|plugs|connection|connections|access point|access points|receptacle|receptacles) | (wall|walls) with [a|the|any] (socket|sockets|outlet|outlets) | electrical and gas (outlets|sockets) | [wall|power|electrical|electric|mains|electricity] (socket|sockets|outlet|outlets|plugs) | (wall|power|electrical|electric|mains|electricity) (plug|supply|point|points) | power source | power sources | power | plug sockets | power plug | electricity | electrical power [source|sources|supply]
place wall: [full height|long|free|clear|solid] (stretch|section|length|run|expanse|piece) of [the] wall
place wall: [one or] two walls | [one of the] (long|longer|longest|short|shorter|two|main) (wall|walls) | [same|solid|long|main|free|empty|blank|any|one|single|adjacent|nearby|side|rear|exterior|interior|outer|inner|outside|inside|dry|structural|load bearing] (wall|walls) | wall space | perimeter | edge of the room | edges of the room | perimeter of the room | side of the room | walls of the room
place ceiling: ceiling | ceilings
place room: [whole|entire|main] (room|bedroom|living room|dining room|kitchen|office|study|bathroom|studio|space|workshop|workroom|hall|library|gym|nursery|shop|store|chapel|church|cellar|bakery|salon|clinic|surgery|pharmacy|boutique|gallery|lounge|attic|basement|laboratory|lab|cafe|restaurant) | floor plan | room 's space | center of attention | layout
place floor: floor | ground
area area: spots | area | zone | region | section | space | nook | spot | area 's | zones | areas | arrangement | group | station | location
group all: nothing | [all|each|every|any|no] [of the] (object|objects|item|items|piece|pieces|furniture|equipment) [of] [furniture|equipment] | (pieces|piece|items|item) of furniture | whatever [is|stands] (opposite|across from|in front of|next to|beside|behind) it | whatever [is|stands] (there|opposite|behind|beside|in front) | furniture pieces | furniture | all furniture | furnishings | each piece | anything | everything | large furniture
group others: [any|all|every|the|each] other (large|big|tall|major|main|nearby) (object|objects|furniture|items|pieces) | [any|all|every|the|each] other (object|objects|furniture|furnishings|item|items|piece|pieces) [of furniture] | (other|surrounding|adjacent|nearby|neighbouring) (furniture|objects|items|pieces) [pieces] | anything else | everything else | the rest of the furniture
vague arrangement: (these|the|all these|such) (constraints|considerations|guidelines|placements|arrangements|suggestions|adjustments) | (by|through) (adhering to|following|considering|implementing) (these|the|this) | (adhering to|following) these | this (arrangement|layout|setup|configuration|placement|revised list|list) (ensures|helps|aims|maintains|provides|will) | overall layout
group others: any (obstruction|obstacle|object|furniture|item|thing) (behind|in front of|opposite|beside|next to) (it|them)
group primary: [the|these|all] (primary|main|major|key) (objects|object|pieces|piece|items|furniture|furniture pieces)
group seating: (seating|seats|seat) [furniture|arrangement|pieces]
group heat: heat source | heat sources | sources of heat
pronoun it: it | itself | this piece | this object | its
pronoun them: [the|these|those|of these|of the] (pieces|objects) [of furniture] | all (three|four) (pieces|objects|items) [of furniture] | the (three|four) (pieces|objects|items) [of furniture] | them | they | their | themselves | these two | the two | both of them | the three | all three [pieces of furniture] | these objects
quantity each: neither_one | either of [the] | none of the |any of the | each | every | each of the | every one of the | all | all the | both | both of the | all of the | any | each one of the | either | two | three | four | five | six | eight | both the | all four | all six | the two | the four | the three | the six | pair of | a pair of
ordinal 1: first | one
ordinal 2: second | the other
ordinal 99: last | rearmost
ordinal 3: third
ordinal 4: fourth
ordinal 5: fifth
ordinal 6: sixth
ordinal 7: seventh
ordinal 8: eighth
ordinal 9: ninth
ordinal 10: tenth
ordinal 11: eleventh
ordinal 12: twelfth
vague paths: [main|clear|walking|foot|high|traffic|frequently used] (path|paths|pathway|pathways|walkway|walkways|traffic|passageway|passageways|circulation|thoroughfare) [path|paths|flow|way|areas|zones] | (foot|high) traffic [areas|paths|zones|flow|pathways] | flow [of] [movement|traffic]
  | [easy] movement | [logical] workflow | flow | walkthrough | main route | routes | access paths | accessible path | aisle | aisles | movement paths | high traffic | circulation space | walking paths
vague lighting: [a] [good] [source|sources] of light | light source | light sources | well lit | [overhead|natural|ambient|good|task|proper] lighting | light | natural or artificial | glare | sunlight | direct sunlight | illumination | well lit area | lamp light | overhead lighting
vague comfort: comfort | relaxation feel | ambience | ambiance | cozy | cosy | aesthetics | atmosphere | style | balance | visual balance | minimalist | view
vague services: ventilation | ventilation system | drainage | plumbing | water supply | gas | water | airflow | air flow | air circulation | ventilated | gas outlets | gas outlet | water source | moisture | humidity | temperature | radiator | radiators | vent | vents | air vent | flammable materials | materials
vague height: lid | lids | top | eye level | height | heights | at eye level | level surface | [at] [a] (comfortable|suitable|appropriate) height | top side | surface | reachable height | from above | tabletop
side front: drawers | drawer | (chair|entry|entrance|use|user 's|accessible front|door|drawer|working|user|sitting|seating|opening|access|viewing|operating) side
vague lighting: [window] reflections | [window] glare | reflection | illuminate | illuminates | brightness
vague comfort: [out of] sight | sound | noise | decor | functionality | privacy | crowding | efficient use | appealing | quiet | conversation | interaction
vague clutter: (electrical|electronic|electric|heating) (equipment|device|devices|appliance|appliances|items) | obstructions | obstacles | obstruction | major obstructions | clutter | workspace | important areas | hazards | other functions | essential areas | other areas | activities
and: (and|as well as) from | and [the] [outer|front|back|near|nearest|closest] (edge|edges) of | and | as well as | plus | along with | and also | in addition to
or: or | and or
)";
}

}  // namespace flair::translator
