using UnityEngine.SubsystemsImplementation;

namespace UnityEngine.XR.ARSubsystems;

public class XRImageTrackingSubsystemDescriptor : SubsystemDescriptorWithProvider<XRImageTrackingSubsystem, XRImageTrackingSubsystem.Provider>
{
}
