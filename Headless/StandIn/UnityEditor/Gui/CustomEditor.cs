namespace UnityEditor;

public class CustomEditor : Attribute
{
    public CustomEditor(Type inspectedType) => InspectedType = inspectedType;

    internal Type InspectedType { get; }
}

public sealed class CanEditMultipleObjects : Attribute
{
}

[AttributeUsage(AttributeTargets.Class, Inherited = false, AllowMultiple = true)]
public sealed class CustomPropertyDrawer(Type type, bool useForChildren) : Attribute
{
    internal bool Draws(Attribute attribute) => useForChildren ? type.IsInstanceOfType(attribute) : type == attribute.GetType();
}
