using Nowpose.Anchoring;
using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>Simulates a device that has one spatial anchor.</summary>
sealed class FakeSpatialAnchors : MonoBehaviour, ISpatialAnchors, ISpatialAnchor
{
    public bool IsReady => true;
    public SpatialAnchorState State { get; set; } = SpatialAnchorState.Tracking;
    public RigidTransform? Pose { get; set; }
    public string KeptAs { get; set; }
    public string Problem { get; set; }

    public ISpatialAnchor Hold(in RigidTransform pose)
    {
        Pose = pose;
        return this;
    }

    public ISpatialAnchor Find(string name) => name == KeptAs ? this : null;
    public void Forget(string name) => KeptAs = null;
    public void Keep(string name) => KeptAs = name;
    public void Dispose() => Pose = null;
}
