namespace UnityEngine;

public sealed class SerializeField : Attribute
{
}
