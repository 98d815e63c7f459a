namespace UnityEngine;

public abstract class IntegratedSubsystemDescriptor : ISubsystemDescriptorImpl, ISubsystemDescriptor
{
    public string id => "stand-in";

    ISubsystem ISubsystemDescriptor.Create() => null;
}
