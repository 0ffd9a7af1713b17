// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/lexicon.h"

namespace flair::translator {

// What is related to what, and how: the first part of the lexicon, in the form of lexicon_entries.cc.
std::string_view LexiconRelations() {
  return R"(
relation against: pulled up (to|against) | (hug|hugs|hugging) | [pushed|placed|set|positioned|backed|standing] [right|hard|close|tight] up (against|to) | right against | (pushed|moved) [right] [up] to | (placed|set|positioned|standing|sitting) flush against | connected with | (installed|mounted|fixed|positioned|placed|set) against | [tucked|pushed|pressed|butted|lean|leans|leaning|rest|rests|resting|sits|stands|backs] [right|up|flush|snug|snugly|tight] against | (pushed|set|moved) back against | (pushed|set|placed|pressed) flat against | flat against | flush (with|to) | backed (onto|against|by) | backs onto
  | touching | touches | touch | adjoining | adjoins | abutting | abuts | backing onto | (secure|secured|anchor|anchored|fasten|fastened|fix|fixed|attach|attached|bolted|screwed) (to|onto) | (join|joins|meet|meets|adjoin) [up with|with]
relation against: (flush|right|hard|close|tight|directly) up against
relation against: be pulled up [close] (to|against)
relation against: (lined up|lining up|in a row|side by side) against | (squeezed|shoved|jammed|crammed|propped|stood|abutted|nestled|nudged|squared|placed|set|pushed|positioned) [up|in|flush|right|hard|tightly|snugly] [up] against | in [direct] contact with | touching against
relation against: flat on | flush on | (hard|square|squarely|plumb|tight|straight|snug) against
relation against: (protected|supported|sheltered) by | (secure|fix|attach|anchor|fasten|bolt|screw|securing|fixing|attaching|anchoring|fastening) [it|them] (to|onto|against)
relation along: line | lines | lining
relation along: along | alongside | lined up along | runs along | running along
relation not_aligned: (avoid|not) aligning
relation aligned: (line|lines|lining) up with | aligned with | align with | aligns with | in line with | lined up with | aligned | aligned to
relation further: [be|is|are] (further|farther) [away] than
relation not_further: (no|not) [be] (further|farther) [away] from
relation not_closer: (no|not) [be] (closer|nearer) to
relation near: [at|within|only] [a] short distance (from|to|of) | [within] [easy|convenient|quick|comfortable] reach from | exposed to | relative to | placement relative to | not (be|placed|located|positioned) [placed|located|positioned] [too|very] far [away] from | close at hand | at hand | within [easy|close|arm 's|arms|convenient|comfortable] reach | [within] [an|a] (arm 's|arms) length (of|from) | close enough (to|for) | near enough (to|for) | in conjunction with | together with | combined with | near | (closest|nearest) to | nearby | close (to|by) | close | closely | near to | [in|within] [close|easy|immediate] proximity (to|of|with)
  | proximity to | in the vicinity of | within [easy|arm 's|arms|comfortable|convenient|close] reach of | not far from | not too far from
  | easily accessible from | conveniently accessible from | in reach of | [within] [a] comfortable sitting distance (from|of)
  | (in|within) [a|an] (comfortable|short|reasonable|walking|easy|convenient|close|small|serving|reaching|conversational|conversation|accessible|practical) distance (of|from|to) | within [easy|arm 's|close] reach from | within easy reach | within arm 's reach
  | convenient to | (closer|nearer) to | nearer | as close as possible to | grouped with | paired with | grouped near | at arm 's length from
relation near: (receive|receives|receiving) [plenty of|some|good|enough] [natural] (light|daylight|sunlight) from
relation near: (benefit|benefits|benefiting) from | [take|takes|taking] advantage of | (make|makes|making) [good] use of | (pair|pairs|pairing) [up] with | in the (neighbourhood|neighborhood|immediate vicinity) of | (accessible|reachable) by
relation near: (reachable|accessible|usable) (by|for|to) [a|the] (person|people|user|someone|somebody|anyone|anybody|guests|visitors|whoever) [who (sits|is sitting|is seated|lies|is lying|stands|works)|sits|works|sitting|seated|lying|standing|working] (on|in|at)
relation near: [within] [easy] reach (of|for) (a person|people|someone|somebody|anyone|the user|guests) (who sits|who is sitting|sitting|seated|lying|standing|working) (on|in|at)
relation nearby: have nearby access to
relation next_to: next to | beside | adjacent to | directly adjacent to | immediately next to | adjacent | alongside of | side by side with
  | by | at
relation to_side: (at|on|by|near|to) (one|either|the far|the other) end of | (to|on|at) the other side of | (to|on|at) the (left or right|right or left) [side] of | (to|at|by) (the|one|either) side of | against the matching side of | to [one of] the sides of
relation side_by_side: [stand|placed|arranged|positioned] side by side | [stand|standing] in a row | in (a|one) row | in (a|one) line | in one run | in a [continuous] run
  | (form|forms|forming) (a|one) [single|straight|continuous|neat|tidy] (row|line|bank) | (arranged|placed|set up|aligned|standing|stand) in (a|one) [single|straight|continuous|neat] (row|line) | lined up
relation back_to_back: [placed|standing|stand] back to back [with|to|against]
relation together: [direct|immediate] (neighbours|neighbors)
relation together: (go|goes|belong|belongs|stay|stays) together | (form|forms|forming|create|creates|creating|make|making) (a|one) [seating|conversation] (group|cluster|grouping|ensemble|area) | (cramped|crammed|crowded|squeezed|packed|pushed) together | in (close|immediate) proximity | close together | (grouped|placed|kept) together
relation each_side_of: (one|two) per side of | per side of | (stand|stands|standing|sit|sits|sitting) on (each|either|both|opposite) (side|sides) of | on (each|either|both) (side|sides) of | at (each|either) side of | on opposite sides of
  | flanking | flank | flanks | one on each side of | on both sides of | at both sides of | to (each|either) side of
relation left_of: (should|must|can|may|to) be left of | (to|on|at) [the] left [hand] [side] of | left of | immediately left of
relation right_of: (to|on|at) [the] right [hand] [side] of | right of | immediately right of
relation foot_of: (at|by|near|against|below|beyond|beneath) the foot [end] of
relation end_of: at the end of
relation left_of: (to|on|at) [the|its] (immediate|direct|far|near) left [hand] [side|end] of
relation right_of: (to|on|at) [the|its] (immediate|direct|far|near) right [hand] [side|end] of
relation head_of: (at|by|near) the head [end] of
relation left_of: (on|at|to|along) [its|the] left [hand] (side|end|edge) of
relation right_of: (on|at|to|along) [its|the] right [hand] (side|end|edge) of
relation behind_user: behind (the|a|any) (user|person|occupant|sitter|operator|worker|reader|student|player)
relation behind: (hidden|concealed|tucked) [away] behind | behind | in back of | at the back of | at the rear of | to the rear of
relation in_front_of: (at|in) the front of | [of] (open|free|clear|unobstructed) (area|zone) in front of | right in front of | in front of | (centered|centred|central|centrally) in front of | [directly] before | ahead of | in the front of
relation in_front_of: (lined up|lining up|in a row) in front of
relation in_front: (open|free|clear|unobstructed) (area|zone) in front | in front | at the front
relation at_sides: (on|at|to|by|along) (each|either) (side|end) | (on|at|to|by) (both|each|either) (end|ends) | along both sides | (on|at|to) (both|each|the|either) sides | on either side | on each side | at the sides | on both sides
relation all_sides: from (each|every) side | from (any|all|every) (angle|angles|direction|directions)
relation each_side_of: on opposing sides of
relation each_side_of: (at|on|by|to) (each|both) (end|ends) of
relation each_side_of: (to|on|at) the left and [the|to the|on the] right [hand] [side|sides] of
relation at_sides: (to|on|at) (the|its) left and (to|on|at) (the|its) right | to (the|its) left and right
relation all_sides: all the way (around|round) | (sit|sits|seated|stand|stands|walk|gather) (on|at|from) [all|every] [four] (side|sides) | on all (accessible|open) sides | on all [four] sides [of] | on every side [of] | at all sides [of] | from all sides
relation around: around | round | surrounding | all around | all round
relation surround: surround | surrounds | surrounded | arranged around | [evenly] spaced around | [placed|grouped|gathered|distributed|set] (around|round)
  | stand (around|round) | against each side of | on all sides round
relation surrounded_by: (surrounded|encircled|ringed) [(on|from) all [four] sides] by
relation surround: [evenly] (distributed|arranged|spread|seated) [evenly|equally] (on|at|along|against) (all|every) [four] (side|sides) of
relation flanked_by: (flanked|framed|bracketed|bordered) by
relation one_each_side: [with] one (on|at|to) (each|either) (side|end)
relation between: [in] between | [in] between the [outer|front|back|near|nearest|closest] (edge|edges) of
relation on: (strung|hung|stretched|draped|spread|mounted|running|runs|laid) across
relation on: [a] part of | [the] top of | [standing|sitting|resting|placed|perched|perching|stands|sits|rests|lies|lying|set|stored|kept] on top of | on the (mantel|mantelpiece|ledge|lid|seat|tray|rim) of | perched on | stored on | draped over | spread (over|across) | in (a|its) (separate|own|dedicated) | on | on top of | atop | onto | upon | resting on | sits on | sit on | stand on | stands on | standing on | sitting on | inside | in | into
  | on one of the shelves (of|inside|in|on) | on a shelf of | on the (top|surface) of | on the (upper|lower|top|middle|bottom) (shelf|shelves) of
  | on the (upper|lower|top|middle|bottom) | laid on | lies on | lie on | rests on | rest on | within | displayed on | inside of
relation under: under | underneath | beneath | below | extending (under|beneath) | extends (under|beneath) | spread under
relation partly_under: [extends|extend|extending|reaching|reaches|coming|out] from (under|beneath|underneath) [the] [front] [legs|half|part|edge] [of] | (under|beneath|underneath) the front (legs|half|part|edge) of | (partially|partly|half) (under|underneath|beneath) | lies (partially|partly|half) (under|underneath|beneath)
  | extends partly under | [tucked] under the front [half|part] of | (extending|reaches|reaching) (out|forward) from under | forward under
relation under_center: centered (under|underneath|beneath) | (centred|centrally|central|centered) (under|beneath|underneath) | [lies] centred under
relation above: above | over | [directly|hangs|hung|suspended|hanging|centred|centered] (above|over) | over the top of
relation facing: [be] [able to] (see|watch|sees) | (look|looks|looking) straight at | [within|in] sight of | (face|facing|faces) onto | [to|and] (allow|allowing|have|having|provide) [a|an|the] [clear|good|direct|unobstructed] (view|line of sight) (of|to|from) | for [comfortable|easy] viewing (of|from) | comfortable viewing from | towards | toward | face | faces | facing | faced (towards|toward|to) | facing (towards|toward|to) | oriented (towards|toward|to) | turned (towards|toward|to)
  | looks (at|towards|toward|onto|out|on) [of] | look (at|towards|toward|onto|out) [of] | looking (at|towards|toward|onto|out) [of] | [be] angled (towards|toward)
  | pointed (towards|toward|at) | pointing (towards|toward|at) | [a|an] [clear|good|direct|unobstructed|direct] (view|visibility|line of sight) (of|to|from|onto)
  | in [the] view of | in [direct] [line of] sight of | for view of | overlooking | orient (towards|toward|to) | turn (towards|toward|to) | [clear] line of sight (from|to)
  | has a view of | in [full] view from | within view of | (directed|oriented|orientated|turned|pointed|angled) (towards|toward|at|to)
relation facing: (keep|keeping) (an eye|watch) (on|over) | monitor | monitoring | supervise | supervising | oversee | overseeing | observe | observing
relation seen: visible | seen | viewable | in view | in sight
relation visible_from: [clearly|easily|directly|fully|readily] (viewable|visible|seen|viewed|watched) [clearly|easily|directly] from | (visibility|visible) from
relation facing: (look|looks|looking|view|views) (over|across|out over) | (aimed|aiming|trained|focused|focussed|shining|shone|directed) (at|on|onto|towards|toward)
relation facing_away: (look|looks|looking|oriented|orientated|angled|directed|turn|turns|turning|point|points) [directly] away from
relation facing_away: [to] (face|faces|facing|faced|turned|oriented|pointed|pointing) [directly] away from
relation facing_each_other: (opposite|across from) (each other|one another) | (face|facing) each other | face one another | facing one another
relation opposite: opposite | opposite to | opposite from | across from | directly across [from] | on the opposite side of
relation same_direction: (face|faces|facing|oriented|orientated|point|points|pointing|turned|look|looking) [in|towards|to] the same (way|direction)
relation same_direction: (face|faces|facing) [in] the same (direction|way) (as|like) | same (direction|orientation|way) (as|like) | oriented the same way as
relation parallel: parallel [to|with] | is parallel to | run parallel to | runs parallel to
relation perpendicular: (at|in|form|forms|forming|make|makes|making) [a] right (angle|angles) | at right angles [to|with]
relation perpendicular: perpendicular to | at [a] right (angle|angles) to | perpendicular | form [a] right angle [with|to] | forms a right angle (with|to) | [turned|rotated|oriented|set|placed|standing] at (90|ninety) degrees to | [turned|rotated|oriented|set|placed] at a (90|ninety|right) degree angle (to|with) | at a 90 degree angle to | square to
relation not_angle: at [a|an] (45|30|60) [degree|degrees] angle (to|with) | at an angle [to] | diagonally | diagonal | at a 45 degree angle
relation not_angle: (diagonal|diagonally) (across|opposite) [from|to] | kitty corner (to|from) | (at|on) a (slight|small) angle [to]
relation crowd: crowded by | crowd | crowds | crowding
relation away_from: across the room from | [well|stand|stands|stay|stays|keep|remain|remains] well clear (of|from) | (stand|stands|standing) clear (of|from) | as far [away] as possible from | [kept|keep] out of reach (of|from) | clear distance from
relation away_from: from (the|its) (center|centre|middle|centerline|centreline) to [any|the] | (distinct|isolated|detached|secluded) from | far enough [away] from | [slightly|well] off [of] | stand apart from | removed from | remote from | away from | far from | far away from | [a|at a] [safe|reasonable|good|fair|some|comfortable|certain|suitable|sufficient|adequate|proper] distance (from|to) | apart from | separate from | from the [outer|front|back|near|nearest|closest] (edge|edges) of
  | separated from | distant from | distance from | [well] (clear away|apart) from | from | safe distance | at a (distance|remove) from | at a [safe|good|reasonable] distance | gap from | spaced from | distanced from | a gap from
relation no_gap: (no|zero|without [a|any]) (gap|gaps|space|spacing) [in between]
relation apart: (separated|spaced|divided) by | [set|placed|kept] apart by | (some|enough|adequate|sufficient|clear) separation | separate | separated | distinct | apart | [spaced|set] apart [from each other] | in (different|separate|distinct) (areas|parts|corners|sections) [of the room] | separating | separates | (on|at) opposite ends of the room | (on|at) (opposite|different|other) (sides|ends|walls) of the room | on different sides | away from each other | from each other | from one another
relation away: away | off
relation away: out of reach
relation not_prevent: (not|never|nor) (prevent|stop|keep|hamper) | without (preventing|stopping)
relation block_view: (block|blocks|blocking|obstruct|obstructs|obstructing|interrupt|interrupts|break|breaks|spoil|spoils) [the] (view|views|sightline|sightlines|sight|line of sight) from
relation block: (cut|cuts|cutting|take|takes|keep|keeps) (off|out|away) [the] [natural] (light|daylight|sunlight|view) (from|of|through)
relation block: (reduce|reduces|reducing|hinder|impede|restrict|limit|obstruct|block) [the] access (through|to|into|from)
relation block: (block|blocks|blocking|obstruct|obstructs|obstructing|hinder|hindering|restrict|limit|limiting|reduce|reducing) [the] [natural] (light|sunlight|daylight|airflow|view|ventilation) [coming|entering|flowing] (from|through|of|in from|to) | bumped into | struck | knocked into | (overlap|overlaps|overlapping|conflict|conflicts|conflicting) with | hamper | hampers | hampering | hampered | hindered | impeded | obscured | restricted | inhibit | inhibits | inhibiting | disturb | disturbs | disrupt | disrupts | bump into | bumps into | bumping into | crash into | knock into | (block|blocks|blocking|obstruct|obstructs|obstructing|hinder|hinders|impede|impedes|hamper|restrict|restricts) [the] (path|way|route|access) (to|of) | get in the way | (block|obstruct) or limit [access (to|of)] | limit access (to|of) | limits access (to|of) | obstruct [the] (front|side) access (to|of) | block [the] (front|side) access (to|of) | (block|blocks|blocking|obstruct|obstructing|restrict) [direct|easy|the] access (to or from|to and from|to|of) | restrict | restricts | restricting | restrict access (to|of) | block | blocks | blocking | blocked | obstruct | obstructs | obstructing | obstructed | obstruction (of|to) | interfere [with] | interferes [with] | interfering with | impede
  | impedes | impeding | hinder | hinders | hindering | cover | covers | covering | covered | obscure | obscures | obscuring | encroach on | encroaching on | intrude (on|into) | get in the way of | in the way of
  | block [the] (view|views|light|access|opening|swing|use|view or access|access or view) (to|of|from|through|for) | block light from | block or cover | (block|obstruct) [the] [natural] (light|view) [coming] from
  | obstruct [the] [easy] (view|views|access|use|opening|swing) (to|of|from|for) | blocking [the] [natural] (view|access|light|opening|swing|use|view or access) (to|of|from|through|for)
  | obstructing [the] (access|view|use|opening|swing) (to|of|from|for) | placed over | placement over | in the path of | interfere with [the] (opening|swing|use|access|operation) (of|to) | stand in the way of
  | in [the] direct line of | in the (swing|line|arc) of | obstruct or block | block or obstruct | collide with | collides with | colliding with | hit | hits | hitting | in the swing path of | overlap | overlaps | overlapping
relation block: (narrow|narrows|narrowing|constrict|constricts|constricting|compromise|compromises|compromising|encumber|encumbers|encumbering|congest|congests|congesting|impair|impairs|impairing|shade|shades|shading) [access to] | (stick|sticks|sticking|jut|juts|jutting|protrude|protrudes|protruding|project|projects|projecting|extend|extending|poke|poking) into
relation clear_of: [be|is|are|remain|remains] clear of | out of the way of | unobstructed by | free of | free from | [stays|stay|keep|keeps|kept|keeping] clear (of|from) | leave [enough] (space|clearance|room) for | outside [of]
  | clear for | out of
relation clear_of: (kept|keep|keeping|remain|remains|remaining|left|leave|stay|stays) (free|clear) of
relation clear_of: (out of|outside|outside of|clear of|away from) [the] [opening] (path|way|swing|arc|radius|range|sweep|line) of
relation wall_placement: wall placement | (placement|positioning) (against|along) [a|the] wall
relation keep_clear: (kept|keep|remains|remain|left|leave|leaves|be) (clear|free|unobstructed|unblocked|open) | unobstructed | unblocked | not obstructed | stays (clear|free)
relation keep_front_clear: [the] (area|space|zone|floor space|floor area) in front of
relation accessible: passable | accessible (at|to|for) a (depth|distance|width) of | accessible | fully accessible | easily accessible | reachable | easy to (reach|access|get to) | approachable | accessibly | (unobstructed|easy|convenient|clear|full|direct) access
  | accessed | accessed easily | access is (needed|possible) | can be reached | be reached | free access | access
relation power_access: plugged in | (plug|plugging) in
relation power_access: (power|electrical|electric|electricity|socket|outlet) (access|connection|connections|accessibility)
relation accessible_from: [be] possible to (get to|reach|walk up to) (it|them) (from|on|at) | accessibility (from|on|at) | (can|could|may|should|must|to) be [easily] (reached|accessed|approached|used) (from|on|at) | (easy|possible) to (reach|access|approach|use) (from|on|at) | approachable (from|on|at|along) | [easily|conveniently|readily|quickly] (reached|reachable) from | readily accessible from | accessible (side|sides) | (accessible|accessed|reachable|approached|used|usable) (from|on|at|along) | access (from|on|at|along)
relation accessible_from: (reach|access|approach|get to|get at|use|serve) (it|them) (from|on|at)
relation accessible_from: [be] [able to] (work|operate) on (it|them) from
relation accessible_from: [be] [able to] (work|working|operate|operated|serve|served|treat|approach|approached) (from|along|on|at)
relation reach: [be] able to (reach|get to)
relation step_back: [be] [able to] (step|stepping|steps) back
relation across: across
relation access_to: (get|getting) at | availability of | access to | accessibility to | (easy|good|convenient|quick|direct|ready|clear) access (to|of) | within reach of | connected to | power from | plugged into | plug into | [easy] access from
relation allow_access_to: [to|and] (allow|allows|allowing|provide|provides|permit|ensure) [for] [easy|clear|free|full|convenient|unobstructed|enough] access to
relation pull_out: [to] (pull|move|slide|push|pulling|moving|sliding) (it|them|the chair|the chairs|chairs|a chair|the stool|the stools) (out|back|in and out|in or out) | [enough|sufficient|adequate|ample] (room|space|clearance) to (move|slide|push|roll|pull) [it|them] (back|out|in and out|in) [from] | [be] (moved|pulled|pushed|slid|rolled) (out|in and out|in or out|in out|in / out|out and in|in and back) [from (it|underneath)] | [to] [be] moved back | [to] [be] (pulled|pull|push|pushed|move|slide) (out|back|in and out|in) | [to] pulling [it] (out|back) | [to] [be] (roll|rolled|rolling|slid|slide|sliding|moved|scoot|pushed) (out|back|backwards|backward|in and out) | back out | pull it out | movement space | allow movement space | move back
relation pull_out: [to] [be] (drawn|pulled|slid|rolled|moved) (up|out|back|forward)
relation swing_open: [be] [fully|completely] extended | to extend [fully|completely]
relation pushed_in: [be] (moved|pulled|pushed|slid|rolled) in
relation swing_open: [allow|allows|allowing|permit] [for] [the] (full|complete|free|unobstructed) opening of | to open | [should] [be able to|able to|to] open [up] [fully|freely|completely|easily|properly] | opened | opens (fully|freely) | (opening|operation) | can open | swing open
relation space: [of] [clear|free|open|unobstructed] (working|work|usable|standing|manoeuvring|maneuvering|play|stretching|leg|operating|activity) (space|room) | of room (to|for) | (have|has|having|need|needs|require|requires) room (to|for) | of room | breathing room | (clearance|clear|free) depth | space | distance | gap | clearance | spacing | separation | buffer | clearances | [of] [clear|open|free|ample|adequate|sufficient|empty|unobstructed|walking|viewing|circulation|movement] (space|clearance|gap|spacing|distance|separation|buffer|passage|clearances) [of] | enough (space|room) | (leave|leaves|leaving|allow|allows|allowing|provide|provides|providing|is) room (for|to) | there is room | has room | room to (move|walk|pull|open|sit) | clearance space | clear floor
  | clear area | floor space | clear floor space | elbow room
relation space: [clear|enough|adequate|sufficient|ample] (space|room|clearance) (should|must) be (left|kept|maintained|provided|allowed|ensured)
relation space: [of] [clear|open|free|adequate|sufficient|enough] (walking|circulation|movement|viewing|maneuvering) (space|clearance|distance|area)
relation space: [clear] (walking|circulation|walkway|movement) room | space to walk | (ample|adequate|sufficient|more) room
  | [enough|ample|adequate|sufficient|clear|more] (space|room) to (move|walk|navigate|maneuver|manoeuvre|circulate|get)
relation space: (leave|leaves|leaving|allow|allows|allowing|provide|provides|providing|maintain|extra|some|more|walking) room | [of] (clear|free|open|unobstructed|empty) floor (space|area) | (clearance|clear|free|buffer) (zone|area)
relation space: [be] possible to (walk|pass|move|step|squeeze|get)
relation space: (be able to|able to) (pass|walk|get past|squeeze|step) | [of] (clear|free|open|unobstructed|empty) floor
relation space: [of] [clear|free|open|enough|ample|sufficient|adequate] (space|room|clearance) (to|for) [people to|guests to|someone to|a person to] (move|moving|walk|walking|step|stepping|navigate|navigating|pass|passing|get|getting|manoeuvre|maneuver) [freely|easily|comfortably|safely]
relation legroom: legroom | leg room | leg space | foot room | knee room | (room|space) for [the|your|one 's] (legs|feet|knees)
relation minimal: minimal | kept minimal
relation considered: (in|into) (consideration|mind|account)
relation same_wall: (on|against|along) (different|separate|other) walls [from|than] | (aligned|placed|positioned) (on|along|against) the same (wall|side of the room) | (against|on|along) the same (wall|side of the room) [as] | (share|shares|sharing) (a|the same) wall [with]
relation of: of | reach of
relation pushed_under: (pushed|push|slide|slides|slid|rolled|roll) (under|underneath|beneath)
relation under: (stand|stands|standing) (under|underneath|beneath)
relation pushed_under: (fit|fits|tuck|tucks|tucked|stow|stowed|store|stored) (under|underneath|beneath)
relation under_when_unused: when [it|they] (is|are) not (in use|used|needed|required|occupied|being used) | when (not|un) (in use|used|needed|required|occupied|being used) | when unused
relation centered: (centered|centred) on top of | [be] (centered|centred|center|centre) | [placed|located|positioned] (centrally|central) | central | centrally | in the middle | in a central (location|position|place|spot) | in the (center|centre)
  | at [its|the] (center|centre) | center (of|on|in) | centre (of|on|in) | [in|at|on|near|towards] the (center|centre|middle) (of|in|on) | middle of | [in|at] (center|centre|middle) of
  | centred (in|on|within|at) | centered (in|on|within|at) | centrally (in|on|within|located|positioned|placed|hung) [in|on|within] | in the middle of | on the (center|centre) line of | central [location] (in|within|to)
  | (center|centre) of | toward the (center|centre) of | [near] the (center|centre) | centrally located within | island | as an island | as [a] (center|centre) piece | centerpiece (of|in) | central to | free standing island
  | (center|centre) piece | focal point of | stands free in
relation centered_to: (centered|centred) (relative to|in relation to|with respect to|with regard to)
relation centered: centered along [the|its] (length|width) of | centrally along the (length|width) of
relation centered: in the central (part|area|portion) of | in a central (part|area) of
relation wall_centered: centered (on|along|against) | centred (on|along|against) | in the middle of
relation corner: [on|at|in|near|towards|toward] [the|a|its|one] (front|upper|lower|outer|inner) corner [of|on] | [on|in|at] [the] (left|right|far|near|opposite|other) corner (of|on) | in [a|one|the] corner | corner | [in|into] [an|a|the] (empty|unused|quiet|cozy|free|far) corner | corner (of|in) | [in|at|on|near|towards|toward|to] (a|the|one|each|any) [far|near|quiet|free|empty] corner [of] | corners [of] | across [a|the] corner | into (a|the) corner | one corner (of|on)
relation corner_back_left: [on|at|in|near|towards|toward|to] [the|its|a|one] (back|rear) corner [of|on]
relation corner_back_left: [on|at|in|near|towards|toward|to] [the|its] (back left|rear left|left back|left rear|upper left|top left|far left) [hand] corner [of|on]
relation corner_back_right: [on|at|in|near|towards|toward|to] [the|its] (back right|rear right|right back|right rear|upper right|top right|far right) [hand] corner [of|on]
relation corner_front_left: [on|at|in|near|towards|toward|to] [the|its] (front left|left front) [hand] corner [of|on]
relation corner_front_right: [on|at|in|near|towards|toward|to] [the|its] (front right|right front) [hand] corner [of|on]
relation edge: [near|at|by|on|along] [the|an|its] edge | [on|at|near|by|towards|along] (the|an|one) (edge|end) (of|on) | edge of | (on|to) one (end|edge) of | [on|at] the edge of | end of | edges of
relation edge: [slightly] off (center|centre) | (on|at|to) (either|each) end of
relation towards_back: [and] (towards|toward) the (back|rear|wall|back side|back edge) [of] | at the back edge of | [positioned] (towards|toward) the wall
relation towards_back: (toward|towards|near) its (back|rear) [edge|side]
relation into_room: (face|faces|facing|look|looks|looking) into | (angled|oriented|orientated|directed|pointed|pointing|positioned) (into|to|towards|toward) [the] [center|centre|middle|rest|inside] [of] the room | (facing|face|faces|looking|looks|open|opens|turned) [in|into|to|towards|toward] [the] [center|centre|middle|rest|inside] [of] the room | [a|the] [good|clear|full] (view|overview) of [the] [whole|entire|main] room | [a|the] [good|clear|full|comfortable|wide] (view|viewing angle|overview|visibility) (over|across|of|into) [of] [the] [whole|entire|main|rest of the] room | overlooking the [whole|entire|rest of the] room | [have|having|has|with|provide|provides|offer|offers] [a|the] [good|clear|full] (view|overview) of the [whole|entire|main] (area|space) | [have|having|has|with|provide|provides|offer|offers] [a|the] [good|clear|full] (view|overview) of the rest of the (room|space|area) | facing inward | facing inwards | view of the [main|entire|whole] room
relation into_room: (point|points|pointing|open|opens|turned) into
relation into_room: (point|points) (to|towards|toward) the (center|centre|middle|rest|inside) of the room | take in the (whole|entire|rest of the) room
relation into_room: (overlooks|overlook|surveys|commands) the [whole|entire|rest of the] room
relation hanging: (nailed|pinned|fastened|secured|anchored|tacked|taped|clipped|screwed|attached|fixed|affixed|strung|draped) [to|on|onto|across|along|from] | hang | hangs | hung | hanging | suspend | suspended | mounted | mount | mounts | wall mounted | installed | affixed | fixed
relation both_ways: each other | one another
relation hide: hide | hides | hiding
relation freestanding: (stand|stands|standing) free (in|within) the (room|space) | freestanding | free standing
relation nearest: (closest|nearest) object to | any object next to
relation where: where
relation on_wall_of: on the (wall|walls) of
)";
}

}  // namespace flair::translator
