using UnityEngine.Serialization;

namespace UnityEngine.Events;

/// <summary>The persistent calls of an event, as Unity serialises them.</summary>
[Serializable]
sealed class PersistentCallGroup
{
    [SerializeField, SerializedName("m_Calls")] List<PersistentCall> _calls = new();

    internal IReadOnlyList<PersistentCall> Calls => _calls;

    internal void Add(PersistentCall call) => _calls.Add(call);
}
