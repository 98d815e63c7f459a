namespace UnityEngine.XR.ARSubsystems;

public struct XRAnchor : ITrackable
{
    internal XRAnchor(TrackableId trackableId, Pose pose, TrackingState trackingState)
    {
        this.trackableId = trackableId;
        this.pose = pose;
        this.trackingState = trackingState;
    }

    public TrackableId trackableId { get; }
    public Pose pose { get; }
    public TrackingState trackingState { get; }
}
