using System;

namespace UnityEditor;

[AttributeUsage(AttributeTargets.Class, Inherited = false, AllowMultiple = true)]
public sealed class CustomPropertyDrawer : Attribute
{
    readonly Type _type;
    readonly bool _useForChildren;

    public CustomPropertyDrawer(Type type, bool useForChildren)
    {
        _type = type;
        _useForChildren = useForChildren;
    }

    internal bool Draws(Attribute attribute) => _useForChildren ? _type.IsInstanceOfType(attribute) : _type == attribute.GetType();
}
