using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

[DisallowMultipleComponent]
[DefaultExecutionOrder(int.MinValue + 2)]
public class ARTrackedImage : ARTrackable<XRTrackedImage, ARTrackedImage>
{
    public Vector2 size => sessionRelativeData.size;

    public XRReferenceImage referenceImage { get; internal set; }
}
