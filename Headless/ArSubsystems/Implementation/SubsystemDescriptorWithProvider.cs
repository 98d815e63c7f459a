namespace UnityEngine.SubsystemsImplementation;

public abstract class SubsystemDescriptorWithProvider
{
}
