namespace UnityEngine.SubsystemsImplementation;

public abstract class SubsystemDescriptorWithProvider : ISubsystemDescriptor
{
    public string id { get; set; }

    ISubsystem ISubsystemDescriptor.Create() => null;
}
