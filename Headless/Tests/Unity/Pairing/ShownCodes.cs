using Nowpose.Anchoring;
using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Headless.Tests.Unity.Pairing;

/// <summary>A source that sees what a test holds up.</summary>
sealed class ShownCodes : MonoBehaviour, IMarkerSource
{
    public List<string> Texts { get; } = [];
    public HeadsetTime Seen { get; set; }
    public MarkerTracking Tracking { get; set; } = MarkerTracking.Tracking;

    public void Read(List<MarkerSighting> markers)
    {
        foreach (var text in Texts) markers.Add(new MarkerSighting(text, text, RigidTransform.Identity, 0.1, Seen, Tracking));
    }
}
