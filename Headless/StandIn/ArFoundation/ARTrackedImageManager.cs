using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

[DefaultExecutionOrder(int.MinValue + 1)]
[RequireComponent(typeof(Unity.XR.CoreUtils.XROrigin))]
public sealed class ARTrackedImageManager : ARTrackableManager<
    XRImageTrackingSubsystem, XRImageTrackingSubsystemDescriptor, XRImageTrackingSubsystem.Provider, XRTrackedImage, ARTrackedImage>
{
    internal override void OnUpdated(ARTrackedImage image, XRTrackedImage data) => image.referenceImage = new XRReferenceImage(data.Name);
}

[DisallowMultipleComponent]
[DefaultExecutionOrder(int.MinValue + 2)]
public class ARTrackedImage : ARTrackable<XRTrackedImage, ARTrackedImage>
{
    public Vector2 size => sessionRelativeData.size;

    public XRReferenceImage referenceImage { get; internal set; }
}
