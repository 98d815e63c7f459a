namespace UnityEngine;

public sealed class HideInInspector : Attribute
{
}
