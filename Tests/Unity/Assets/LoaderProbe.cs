#pragma warning disable CA1051 // Unity serialises public fields.
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.Serialization;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>A component with a field of each kind that Unity serialises.</summary>
public sealed class LoaderProbe : LoaderProbeBase, ISerializationCallbackReceiver
{
    public int number = 1;
    public double exact;
    public string text = "default";
    public PrimitiveType shape;
    public HideFlags flags;
    public Vector3 place;
    public Quaternion turn = Quaternion.identity;
    public Color colour;
    public Color32 bytes;
    public Transform other;
    public GameObject thing;
    public LoaderProbe probe;
    public LoaderProbeAsset asset;
    public Material material;
    public List<string> words = new() { "kept unless told otherwise" };
    public Transform[] transforms;
    public List<LoaderProbePart> parts = new();
    public LoaderProbePart part;
    public UnityEvent called = new();

    [FormerlySerializedAs("oldName")]
    [FormerlySerializedAs("olderName")]
    public int renamed;

    [NonSerialized] public int unserialised;
    public readonly int unwritable;
    public Dictionary<string, int> unknown;
    public int Property { get; set; }

    public int Deserialised { get; private set; }

    public List<int> Calls { get; } = new();

    public void Call() => Calls.Add(0);

    public void CallWith(int value) => Calls.Add(value);

    void ISerializationCallbackReceiver.OnBeforeSerialize()
    {
    }

    void ISerializationCallbackReceiver.OnAfterDeserialize() => Deserialised = number;
}
