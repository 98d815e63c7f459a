namespace UnityEngine.SubsystemsImplementation;

public abstract class SubsystemWithProvider<TSubsystem, TSubsystemDescriptor, TProvider> : SubsystemWithProvider
    where TSubsystem : SubsystemWithProvider, new()
    where TSubsystemDescriptor : SubsystemDescriptorWithProvider
    where TProvider : SubsystemProvider<TSubsystem>
{
}
