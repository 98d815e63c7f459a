using UnityEngine.SubsystemsImplementation;

namespace UnityEngine.XR.ARSubsystems;

public class XRAnchorSubsystemDescriptor : SubsystemDescriptorWithProvider<XRAnchorSubsystem, XRAnchorSubsystem.Provider>
{
}
