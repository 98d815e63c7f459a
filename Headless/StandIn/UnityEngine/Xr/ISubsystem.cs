namespace UnityEngine;

public interface ISubsystem
{
    bool running { get; }
    void Start();
    void Stop();
    void Destroy();
}

public interface ISubsystemDescriptor
{
    string id { get; }
    ISubsystem Create();
}

interface ISubsystemDescriptorImpl
{
}
