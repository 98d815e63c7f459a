namespace UnityEngine.XR.ARSubsystems;

public interface ITrackable
{
    TrackableId trackableId { get; }
    Pose pose { get; }
    TrackingState trackingState { get; }
}
