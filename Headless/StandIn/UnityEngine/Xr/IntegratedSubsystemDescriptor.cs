namespace UnityEngine;

public abstract class IntegratedSubsystemDescriptor : ISubsystemDescriptorImpl, ISubsystemDescriptor
{
    public string id => "stand-in";

    ISubsystem ISubsystemDescriptor.Create() => null;
}

public class IntegratedSubsystemDescriptor<TSubsystem> : IntegratedSubsystemDescriptor where TSubsystem : IntegratedSubsystem
{
}
