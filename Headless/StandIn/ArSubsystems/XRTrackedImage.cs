namespace UnityEngine.XR.ARSubsystems;

public struct XRTrackedImage : ITrackable
{
    internal XRTrackedImage(TrackableId trackableId, string name, Pose pose, Vector2 size, TrackingState trackingState)
    {
        Name = name;
        this.trackableId = trackableId;
        this.pose = pose;
        this.size = size;
        this.trackingState = trackingState;
    }

    public TrackableId trackableId { get; }
    public Pose pose { get; }
    public Vector2 size { get; }
    public TrackingState trackingState { get; }

    /// <summary>Name of the image in the library.</summary>
    internal string Name { get; }
}
