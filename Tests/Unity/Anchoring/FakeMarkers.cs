using Nowpose.Anchoring;
using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>
/// Simulates a device that sees the markers of a base at 30 Hz, with noise of up to 1 mm and 0.2° per axis. Tests can stop new sightings.
/// </summary>
sealed class FakeMarkers : MonoBehaviour, IMarkerSource, IMarkerProblem
{
    readonly System.Random _random = new(3);
    readonly Dictionary<string, MarkerSighting> _seen = [];
    int _frame;

    public IHeadsetClock Clock { get; set; }

    /// <summary>True pose of the base in the room frame.</summary>
    public RigidTransform Base { get; set; } = RigidTransform.Identity;

    /// <summary>Poses of the markers in the base frame, by payload.</summary>
    public Dictionary<string, RigidTransform> Markers { get; } = [];

    public bool IsBlind { get; set; }
    public string Problem { get; set; }

    public void Read(List<MarkerSighting> markers)
    {
        if (!IsBlind && _frame++ % 2 == 0)
            foreach (var (payload, inBase) in Markers)
                _seen[payload] = new MarkerSighting(
                    payload, payload, Base * inBase * Noise(), 0, Clock.Now, MarkerTracking.Tracking);
        foreach (var sighting in _seen.Values) markers.Add(sighting);
    }

    RigidTransform Noise()
    {
        double Some(double size) => size * 2 * (_random.NextDouble() - 0.5);
        const double Metres = 0.001, Radians = 0.2 * Math.PI / 180;
        return RigidTransform.FromXyzRpy(Some(Metres), Some(Metres), Some(Metres), Some(Radians), Some(Radians), Some(Radians));
    }
}
