namespace UnityEngine;

public class IntegratedSubsystem : ISubsystem
{
    public bool running { get; private set; }

    public void Start() => running = true;

    public void Stop() => running = false;

    public void Destroy() => running = false;
}

public class IntegratedSubsystem<TSubsystemDescriptor> : IntegratedSubsystem where TSubsystemDescriptor : ISubsystemDescriptor
{
}
