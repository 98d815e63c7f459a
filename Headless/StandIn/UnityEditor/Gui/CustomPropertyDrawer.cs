namespace UnityEditor;

[AttributeUsage(AttributeTargets.Class, Inherited = false, AllowMultiple = true)]
public sealed class CustomPropertyDrawer(Type type, bool useForChildren) : Attribute
{
    internal bool Draws(Attribute attribute) => useForChildren ? type.IsInstanceOfType(attribute) : type == attribute.GetType();
}
