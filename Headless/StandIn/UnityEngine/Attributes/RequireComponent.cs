namespace UnityEngine;

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class RequireComponent : Attribute
{
    public Type m_Type0;
    public Type m_Type1;

    public RequireComponent(Type requiredComponent) => m_Type0 = requiredComponent;

    public RequireComponent(Type requiredComponent, Type requiredComponent2) : this(requiredComponent) => m_Type1 = requiredComponent2;
}
