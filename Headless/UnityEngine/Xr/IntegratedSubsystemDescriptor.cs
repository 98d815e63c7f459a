namespace UnityEngine;

public abstract class IntegratedSubsystemDescriptor : ISubsystemDescriptor
{
    public string id => "stand-in";

    ISubsystem ISubsystemDescriptor.Create() => null;
}
