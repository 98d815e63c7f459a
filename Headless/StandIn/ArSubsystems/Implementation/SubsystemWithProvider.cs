namespace UnityEngine.SubsystemsImplementation;

public abstract class SubsystemWithProvider : ISubsystem
{
    public bool running { get; private set; }

    public void Start() => running = true;

    public void Stop() => running = false;

    public void Destroy() => running = false;
}

public abstract class SubsystemWithProvider<TSubsystem, TSubsystemDescriptor, TProvider> : SubsystemWithProvider
    where TSubsystem : SubsystemWithProvider, new()
    where TSubsystemDescriptor : SubsystemDescriptorWithProvider
    where TProvider : SubsystemProvider<TSubsystem>
{
}
