using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

public class ARTrackable<TSessionRelativeData, TTrackable> : ARTrackable
    where TSessionRelativeData : struct, ITrackable
    where TTrackable : ARTrackable<TSessionRelativeData, TTrackable>
{
    public TrackableId trackableId => sessionRelativeData.trackableId;

    public TrackingState trackingState => sessionRelativeData.trackingState;

    public bool pending { get; internal set; }

    protected TSessionRelativeData sessionRelativeData { get; private set; }

    internal void Set(TSessionRelativeData data, Transform parent)
    {
        sessionRelativeData = data;
        transform.SetPositionAndRotation(parent.TransformPoint(data.pose.position), parent.rotation * data.pose.rotation);
    }
}
