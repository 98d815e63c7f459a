using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Unity.Tests.Pairing;

/// <summary>A marker source that sees the codes that a test shows.</summary>
sealed class ShownCodes : MonoBehaviour, IMarkerSource
{
    /// <summary>Creates a source below a session, where the session's components search for sources.</summary>
    public static ShownCodes Below(MrilSession session)
    {
        var codes = new GameObject("Codes").AddComponent<ShownCodes>();
        codes.transform.SetParent(session.transform, false);
        return codes;
    }

    public List<string> Texts { get; } = [];
    public HeadsetTime Seen { get; set; }
    public MarkerTracking Tracking { get; set; } = MarkerTracking.Tracking;

    public void Read(List<MarkerSighting> markers)
    {
        foreach (var text in Texts) markers.Add(new MarkerSighting(text, text, RigidTransform.Identity, 0.1, Seen, Tracking));
    }
}
