namespace UnityEngine.SubsystemsImplementation;

public class SubsystemDescriptorWithProvider<TSubsystem, TProvider> : SubsystemDescriptorWithProvider
    where TSubsystem : SubsystemWithProvider, new()
    where TProvider : SubsystemProvider<TSubsystem>
{
}
