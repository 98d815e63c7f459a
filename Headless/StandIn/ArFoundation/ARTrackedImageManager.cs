using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

[DefaultExecutionOrder(int.MinValue + 1)]
[RequireComponent(typeof(Unity.XR.CoreUtils.XROrigin))]
public sealed class ARTrackedImageManager : ARTrackableManager<
    XRImageTrackingSubsystem, XRImageTrackingSubsystemDescriptor, XRImageTrackingSubsystem.Provider, XRTrackedImage, ARTrackedImage>
{
    internal override void OnUpdated(ARTrackedImage image, XRTrackedImage data) => image.referenceImage = new XRReferenceImage(data.Name);
}
