namespace UnityEngine.Events;

/// <summary>What a call kept in a file passes on.</summary>
enum PersistentListenerMode
{
    EventDefined,
    Void,
    Object,
    Int,
    Float,
    String,
    Bool,
}
