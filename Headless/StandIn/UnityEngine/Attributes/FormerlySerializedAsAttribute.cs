namespace UnityEngine.Serialization;

[AttributeUsage(AttributeTargets.Field, AllowMultiple = true, Inherited = false)]
public class FormerlySerializedAsAttribute : Attribute
{
    public FormerlySerializedAsAttribute(string oldName) => this.oldName = oldName;

    public string oldName { get; }
}
