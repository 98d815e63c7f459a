using System.Collections.Generic;

namespace UnityEngine.XR.ARSubsystems;

/// <summary>What a device has to tell of its trackables since it was asked last.</summary>
interface ITrackingDevice<TTrackable>
{
    List<TTrackable> Changed { get; }
    List<TrackableId> Removed { get; }
}
