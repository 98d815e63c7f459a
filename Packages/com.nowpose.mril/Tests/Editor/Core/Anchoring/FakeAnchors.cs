using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Simulates a device with spatial anchors. A test can move the anchors or change their state.</summary>
    sealed class FakeAnchors : ISpatialAnchors
    {
        /// <summary>Poses of the stored anchors by name, including the anchors of an earlier run.</summary>
        public Dictionary<string, RigidTransform> Kept { get; } = new Dictionary<string, RigidTransform>();

        public List<Anchor> Held { get; } = new List<Anchor>();
        public bool IsReady { get; set; } = true;

        /// <summary>State of an anchor directly after its creation.</summary>
        public SpatialAnchorState StateAtFirst { get; set; } = SpatialAnchorState.Tracking;

        public ISpatialAnchor Hold(in RigidTransform pose) => Add(new Anchor(this) { Pose = pose, State = StateAtFirst });

        public ISpatialAnchor Find(string name) =>
            Kept.TryGetValue(name, out var pose) ? Add(new Anchor(this) { Pose = pose, State = StateAtFirst, KeptAs = name }) : null;

        public void Forget(string name) => Kept.Remove(name);

        Anchor Add(Anchor anchor)
        {
            Held.Add(anchor);
            return anchor;
        }

        internal sealed class Anchor : ISpatialAnchor
        {
            readonly FakeAnchors _device;

            public Anchor(FakeAnchors device) => _device = device;

            public SpatialAnchorState State { get; set; }
            public RigidTransform? Pose { get; set; }
            public string KeptAs { get; set; }
            public string Problem { get; set; }

            // A store that is not loaded yet stores the anchor later.
            public void Keep(string name)
            {
                KeptAs = name;
                if (_device.IsReady) _device.Kept[name] = Pose.Value;
            }

            public void Dispose() => _device.Held.Remove(this);
        }
    }
}
