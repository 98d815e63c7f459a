using UnityEngine.SubsystemsImplementation;

namespace UnityEngine.XR.ARSubsystems;

public class XRImageTrackingSubsystem : TrackingSubsystem<
    XRTrackedImage, XRImageTrackingSubsystem, XRImageTrackingSubsystemDescriptor, XRImageTrackingSubsystem.Provider>
{
    public abstract class Provider : SubsystemProvider<XRImageTrackingSubsystem>
    {
    }
}

public class XRImageTrackingSubsystemDescriptor : SubsystemDescriptorWithProvider<XRImageTrackingSubsystem, XRImageTrackingSubsystem.Provider>
{
}
