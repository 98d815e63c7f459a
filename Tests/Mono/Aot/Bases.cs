using System.Collections.Generic;
using System.Linq;
using Nowpose.Anchoring;
using Nowpose.Kinematics;

namespace Nowpose.Mono.Aot
{
    /// <summary>Finds the base of a robot from exact sightings of three markers.</summary>
    static class Bases
    {
        static readonly BaseMarker[] Markers =
        {
            new BaseMarker("a", RigidTransform.FromXyzRpy(0.2, 0, 0, 0, 0, 0.4)),
            new BaseMarker("b", RigidTransform.FromXyzRpy(-0.1, 0.15, 0, 0, 0, 2)),
            new BaseMarker("c", RigidTransform.FromXyzRpy(-0.1, -0.15, 0, 0, 0, -1)),
        };

        public static void Check()
        {
            var truth = RigidTransform.FromXyzRpy(1.2, -0.4, -0.7, 0.02, -0.03, 2.1);
            var tracker = new BaseTracker(new AnchoringSettings());
            tracker.Use("cell", Markers);
            for (var i = 0; i < 300 && tracker.State != BaseAnchorState.Locked; i++)
            {
                var now = HeadsetTime.FromSeconds(100 + i / 30.0);
                tracker.Tick(now, Seen(truth, now), null, null);
            }

            Program.Require(tracker.State == BaseAnchorState.Locked, "locked: " + tracker.State);
            Program.Require(Distance.Between(tracker.Base.Value, truth) < 1e-6, "the base is at its true pose");
        }

        static List<MarkerSighting> Seen(RigidTransform truth, HeadsetTime now) => Markers
            .Select(m => new MarkerSighting("id of " + m.Payload, m.Payload, truth * m.MarkerInBase, 0, now, MarkerTracking.Tracking)).ToList();
    }
}
