using System.Collections.Concurrent;
using UnityEngine.Serialization;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>A class in a script: a component or a ScriptableObject.</summary>
sealed class ScriptClass : ObjectClass
{
    public const int ClassId = 114;
    public const string ClassName = "MonoBehaviour";
    public const string ScriptField = "m_Script";

    /// <summary>FileID of a ScriptableObject in an asset file.</summary>
    public const long AssetFileId = 11400000;

    static readonly ConcurrentDictionary<Type, ScriptClass> Known = new ConcurrentDictionary<Type, ScriptClass>();

    ScriptClass(Type type) : base(ClassId, ClassName, type, Slots(type).ToArray()) { }

    /// <summary>Returns the class for a type.</summary>
    /// <exception cref="AssetException">The type has a field whose type is not supported.</exception>
    public static ScriptClass Of(Type type) => Known.GetOrAdd(type, t => new ScriptClass(t));

    protected override void ReadOther(string name, YamlNode node, Object target, FileReferences references, Place place)
    {
        var field = SerializedFields.Find(Type, name);
        if (field == null) base.ReadOther(name, node, target, references, place);
        FieldValues.Read(field, node, target, references, place);
    }

    static IEnumerable<Slot> Slots(Type type)
    {
        var isComponent = typeof(Component).IsAssignableFrom(type);
        var head = isComponent
            ? Headers.Component.Append(Slot.Field(type, "m_Enabled"))
            : Headers.Object.Append(Slot.Constant("m_GameObject", AssetReference.None.Write())).Append(Slot.Constant("m_Enabled", Nodes.Number(1)));
        var name = isComponent
            ? Slot.Constant("m_Name", Nodes.Text(""))
            : Slot.Property("m_Name", (Object o) => o.name, (o, v) => o.name = v);
        return head
            .Append(Slot.Constant("m_EditorHideFlags", Nodes.Number(0)))
            .Append(Slot.Checked(ScriptField, (Object o, FileReferences references, Place place) => references.ScriptOf(o.GetType(), place).Write()))
            .Append(name)
            .Append(Slot.Constant("m_EditorClassIdentifier", Nodes.Text("")))
            .Concat(OwnFields(type));
    }

    static IEnumerable<Slot> OwnFields(Type type) =>
        SerializedFields.Of(type).Where(f => f.DeclaringType.Assembly != typeof(Object).Assembly).Select(f => OwnField(type, f.Name));

    static Slot OwnField(Type type, string name)
    {
        try
        {
            return Slot.Field(type, name);
        }
        catch (NotSupportedException exception)
        {
            throw new AssetException(AssetFault.Value, type.Name + "." + name + ": " + exception.Message, exception);
        }
    }
}
