using UnityEngine.SubsystemsImplementation;

namespace Microsoft.MixedReality.OpenXR.ARSubsystems;

public class XRMarkerSubsystemDescriptor : SubsystemDescriptorWithProvider<XRMarkerSubsystem, XRMarkerSubsystem.Provider>
{
}
