namespace UnityEngine;

public sealed class ExecuteAlways : Attribute
{
}
