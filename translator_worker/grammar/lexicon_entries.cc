// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/lexicon.h"

namespace flair::translator {

// One entry a line: "CLASS LEMMA: phrase | phrase ..."; [x] may be left out, (x|y) is either. A line that begins with a
// space continues the entry. The first entry wins when a phrase stands in two of the same length.
std::string_view LexiconEntries() {
  return R"(
relation against: pulled up (to|against) | (hug|hugs|hugging) | [pushed|placed|set|positioned|backed|standing] [right|hard|close|tight] up (against|to) | right against | (pushed|moved) [right] [up] to | (placed|set|positioned|standing|sitting) flush against | connected with | (installed|mounted|fixed|positioned|placed|set) against | [tucked|pushed|pressed|butted|lean|leans|leaning|rest|rests|resting|sits|stands|backs] [right|up|flush|snug|snugly|tight] against | (pushed|set|moved) back against | (pushed|set|placed|pressed) flat against | flat against | flush (with|to) | backed (onto|against|by) | backs onto
  | touching | touches | touch | adjoining | adjoins | abutting | abuts | backing onto | (secure|secured|anchor|anchored|fasten|fastened|fix|fixed|attach|attached|bolted|screwed) (to|onto) | (join|joins|meet|meets|adjoin) [up with|with]
relation against: (flush|right|hard|close|tight|directly) up against
relation against: be pulled up [close] (to|against)
relation against: (lined up|lining up|in a row|side by side) against | (squeezed|shoved|jammed|crammed|propped|stood|abutted|nestled|nudged|squared|placed|set|pushed|positioned) [up|in|flush|right|hard|tightly|snugly] [up] against | in [direct] contact with | touching against
relation against: flat on | flush on | (hard|square|squarely|plumb|tight|straight|snug) against
relation against: (secure|fix|attach|anchor|fasten|bolt|screw) (it|them) (to|onto|against)
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
relation block: (reduce|reduces|reducing|hinder|impede|restrict|limit|obstruct|block) [the] access (through|to|into|from)
relation block: (block|blocks|blocking|obstruct|obstructs|obstructing|hinder|hindering|restrict|limit|limiting|reduce|reducing) [the] [natural] (light|sunlight|daylight|airflow|view|ventilation) [coming|entering|flowing] (from|through|of|in from|to) | bumped into | struck | knocked [over|into] | (overlap|overlaps|overlapping|conflict|conflicts|conflicting) with | hamper | hampers | hampering | hampered | hindered | impeded | obscured | restricted | inhibit | inhibits | inhibiting | disturb | disturbs | disrupt | disrupts | bump into | bumps into | bumping into | crash into | knock into | (block|obstruct|hinder|impede|hamper|restrict) [the] (path|way|route) (to|of) | get in the way | (block|obstruct) or limit [access (to|of)] | limit access (to|of) | limits access (to|of) | obstruct [the] (front|side) access (to|of) | block [the] (front|side) access (to|of) | (block|blocks|blocking|obstruct|obstructing|restrict) [direct|easy|the] access (to or from|to and from|to|of) | restrict | restricts | restricting | restrict access (to|of) | block | blocks | blocking | blocked | obstruct | obstructs | obstructing | obstructed | obstruction (of|to) | interfere [with] | interferes [with] | interfering with | impede
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
relation pushed_in: [be] (moved|pulled|pushed|slid|rolled) in
relation swing_open: [allow|allows|allowing|permit] [for] [the] (full|complete|free|unobstructed) opening of | to open | [should] [be able to|able to|to] open [up] [fully|freely|completely|easily|properly] | opened | opens (fully|freely) | (opening|operation) | can open | swing open
relation space: [of] [clear|free|open|unobstructed] (working|work|usable|standing|manoeuvring|maneuvering|play|stretching|leg|operating|activity) (space|room) | of room (to|for) | (have|has|having|need|needs|require|requires) room (to|for) | of room | breathing room | (clearance|clear|free) depth | space | distance | gap | clearance | spacing | separation | buffer | clearances | [of] [clear|open|free|ample|adequate|sufficient|empty|unobstructed|walking|viewing|circulation|movement] (space|clearance|gap|spacing|distance|separation|buffer|passage|clearances) [of] | enough (space|room) | (leave|leaves|leaving|allow|allows|allowing|provide|provides|providing|is) room (for|to) | there is room | has room | room to (move|walk|pull|open|sit) | clearance space | clear floor
  | clear area | floor space | clear floor space | elbow room
relation space: [clear|enough|adequate|sufficient|ample] (space|room|clearance) (should|must) be (left|kept|maintained|provided|allowed|ensured)
relation space: [of] [clear|open|free|adequate|sufficient|enough] (walking|circulation|movement|viewing|maneuvering) (space|clearance|distance|area)
relation space: [clear] (walking|circulation|walkway|movement) room | space to walk | (ample|adequate|sufficient|more) room
  | [enough|ample|adequate|sufficient|clear|more] (space|room) to (move|walk|navigate|maneuver|manoeuvre|circulate|get)
relation space: (leave|leaves|leaving|allow|allows|allowing|provide|provides|providing|maintain|extra|some|more|walking) room | [of] (clear|free|open|unobstructed|empty) floor (space|area) | (clearance|clear|free|buffer) (zone|area)
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
filler: let | lets | letting | [the] (lower|upper|bottom|main|greater) (part|half|portion) of
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
side front: [the] side with (the|its|their) (door|doors|drawer|drawers|shelves|screen|opening) | keyboard side
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
side side: [at least] one (arm|end|lateral) side | (arm|lateral) side
side side: one or more sides | one or both sides | side | [the] (arm|armrest) | [at least] one side | [at least] one of [its|the] sides | (left or right|right or left) | a side | any side | at least one of its sides | one [free|open] side | one end
side sides: (either|each) (end|arm)
side back: headboards | backrests | headrests | (tank|cistern|rear facing|wall) side
side front: front (legs|feet|half) | (player|customer|customers|guest|visitor|public|viewing|ladder|client) (side|end)
side three: [on|from|at] all [four] [of its] sides (except|but|besides|excluding|save|other than|apart from|except for|but for) [the|its] (back|rear|back side|rear side|wall side|one (against|at|facing) the wall)
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
