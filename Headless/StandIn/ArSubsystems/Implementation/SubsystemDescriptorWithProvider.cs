namespace UnityEngine.SubsystemsImplementation;

public abstract class SubsystemDescriptorWithProvider : ISubsystemDescriptor
{
    public string id { get; set; }

    ISubsystem ISubsystemDescriptor.Create() => null;
}

public class SubsystemDescriptorWithProvider<TSubsystem, TProvider> : SubsystemDescriptorWithProvider
    where TSubsystem : SubsystemWithProvider, new()
    where TProvider : SubsystemProvider<TSubsystem>
{
}
