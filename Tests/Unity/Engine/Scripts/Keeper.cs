using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>A script with one field for each rule of Unity's serialisation.</summary>
sealed class Keeper : MonoBehaviour, ISerializationCallbackReceiver
{
    [Serializable]
    public sealed class Item
    {
        public string text = "new";
        public Transform place;
        [NonSerialized] public int forgotten = 7;
    }

    public int number = 1;
    public Transform target;
    public Item item;
    public Item[] items;
    public List<Vector3> points;
    public string words { get => _words; set => _words = value; }
    public UnityEvent happened { get => _happened; set => _happened = value; }
    [SerializeField] string _words;
    [SerializeField] UnityEvent _happened;
    [SerializeField] Pose _hidden;
    [NonSerialized] public int unsaved = 3;
    public readonly int fixedOnce = 4;
    public Dictionary<int, int> table;
    int _state = 5;

    public Pose Hidden { get => _hidden; set => _hidden = value; }
    public int State { get => _state; set => _state = value; }
    public string Callbacks { get; private set; } = "";

    public void OnBeforeSerialize() => Callbacks += "before ";

    public void OnAfterDeserialize() => Callbacks += "after ";
}
