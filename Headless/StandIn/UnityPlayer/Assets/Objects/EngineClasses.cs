namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>Unity's classes that are supported in prefabs and scenes, with their fields in the format of Unity 2021.</summary>
static class EngineClasses
{
    static readonly ObjectClass[] All =
    {
        new ObjectClass(1, "GameObject", typeof(GameObject), Headers.Object.Concat(GameObjectSlots()).ToArray()),
        new ObjectClass(4, "Transform", typeof(Transform), Headers.Component.Concat(TransformSlots()).ToArray()),
        Component<Camera>(20, "m_Enabled", ("serializedVersion", "2"), "m_ClearFlags", "m_BackGroundColor", "near clip plane",
            "far clip plane", "field of view", "orthographic", "orthographic size", "m_Depth",
            Slot.Field(typeof(Camera), "m_CullingMask", new BitsFormat()), ("m_RenderingPath", "-1"),
            Slot.Constant("m_TargetTexture", AssetReference.None.Write()), ("m_TargetDisplay", "0")),
        Component<MeshRenderer>(23, "m_Enabled", ("m_CastShadows", "1"), "m_ReceiveShadows", "m_Materials"),
        Component<MeshFilter>(33, "m_Mesh"),
        Component<TextMesh>(102, ("serializedVersion", "3"), "m_Text", "m_OffsetZ", "m_CharacterSize", "m_LineSpacing", "m_Anchor", "m_Alignment",
            "m_TabSize", "m_FontSize", ("m_FontStyle", "0"), "m_RichText", Slot.Constant("m_Font", BuiltInAssets.Font.Write()), "m_Color"),
        Component<LineRenderer>(120, ("serializedVersion", "2"), "m_Enabled", ("m_CastShadows", "0"), "m_ReceiveShadows", "m_Materials",
            Slot.Constant("m_Parameters", LineParameters()), "m_UseWorldSpace", ("m_Loop", "0")),
        new OpaqueClass(65, "BoxCollider"),
        new OpaqueClass(81, "AudioListener"),
        new OpaqueClass(108, "Light"),
        new OpaqueClass(223, "Canvas"),
        new ObjectClass(224, "RectTransform", typeof(RectTransform), Headers.Component.Concat(TransformSlots()).Concat(RectSlots()).ToArray()),
    };

    static readonly Dictionary<Type, ObjectClass> ByType = All.Where(c => !(c is OpaqueClass)).ToDictionary(c => c.Type);

    /// <summary>Returns the class with a number and a name; null if there is none.</summary>
    public static ObjectClass Find(int id, string name) => Array.Find(All, c => c.Id == id && c.Name == name);

    /// <summary>Returns the class of an object; null for a script and for a class that is not supported.</summary>
    public static ObjectClass Of(Object target)
    {
        if (target is OpaqueComponent opaque) return Array.Find(All, c => c.Name == opaque.ClassName);
        return ByType.TryGetValue(target.GetType(), out var found) ? found : null;
    }

    static ObjectClass Component<T>(int id, params FieldSpec[] fields)
        where T : Component =>
        new ObjectClass(id, typeof(T).Name, typeof(T), Headers.Component.Concat(fields.Select(f => f.Of(typeof(T)))).ToArray());

    /// <summary>Returns the parameters of a line with the same width everywhere. The width itself is set while the scene plays.</summary>
    static YamlMappingNode LineParameters() => Nodes.Lines(
        ("serializedVersion", Nodes.Number(3)),
        ("widthMultiplier", Nodes.Number(1)),
        ("widthCurve", Nodes.Lines(
            ("serializedVersion", Nodes.Number(2)),
            ("m_Curve", new YamlSequenceNode(Nodes.Lines(
                ("serializedVersion", Nodes.Number(3)),
                ("time", Nodes.Number(0)),
                ("value", Nodes.Number(1)),
                ("inSlope", Nodes.Number(0)),
                ("outSlope", Nodes.Number(0)),
                ("tangentMode", Nodes.Number(0)),
                ("weightedMode", Nodes.Number(0)),
                ("inWeight", Nodes.Text("0.33333334")),
                ("outWeight", Nodes.Text("0.33333334"))))),
            ("m_PreInfinity", Nodes.Number(2)),
            ("m_PostInfinity", Nodes.Number(2)),
            ("m_RotationOrder", Nodes.Number(4)))));

    static IEnumerable<Slot> GameObjectSlots()
    {
        yield return Slot.Constant("serializedVersion", Nodes.Number(6));
        yield return Slot.Checked("m_Component", (GameObject g, FileReferences references, Place place) => new YamlSequenceNode(
            g.GetComponents<Component>().Select(c => Nodes.Lines(("component", references.ReferenceTo(c, place).Write())))));
        yield return Slot.Property("m_Layer", (GameObject g) => g.layer, (g, v) => g.layer = v);
        yield return Slot.Property("m_Name", (GameObject g) => g.name, (g, v) => g.name = v);
        yield return Slot.Property("m_TagString", (GameObject g) => g.tag, (g, v) => g.tag = v);
        yield return Slot.Constant("m_Icon", AssetReference.None.Write());
        yield return Slot.Constant("m_NavMeshLayer", Nodes.Number(0));
        yield return Slot.Constant("m_StaticEditorFlags", Nodes.Number(0));
        yield return Slot.Property("m_IsActive", (GameObject g) => g.activeSelf, (g, v) => g.SetActiveSelf(v));
    }

    static IEnumerable<Slot> TransformSlots()
    {
        // Uses the fields, because values must be written as they were read, but the properties normalise rotations.
        foreach (var name in new[] { "m_LocalRotation", "m_LocalPosition", "m_LocalScale" }) yield return Slot.Field(typeof(Transform), name);
        yield return Slot.Constant("m_ConstrainProportionsScale", Nodes.Number(0));
        yield return Slot.Checked("m_Children", (Transform t, FileReferences references, Place place) => new YamlSequenceNode(
            t.Cast<Transform>().Select(c => references.ReferenceTo(c, place).Write())));
        yield return Slot.Checked("m_Father", (Transform t) => t.parent);
        yield return Slot.Checked("m_RootOrder", (Transform t, FileReferences references, Place place) => Nodes.Number(references.SiblingIndex(t)));
        yield return Slot.Hint("m_LocalEulerAnglesHint", (Transform t, FileReferences references, Place place) =>
            ValueFormats.For(typeof(Vector3)).Write(EulerHint(t), references, place));
    }

    static IEnumerable<Slot> RectSlots()
    {
        yield return Slot.Field(typeof(RectTransform), "m_AnchorMin");
        yield return Slot.Field(typeof(RectTransform), "m_AnchorMax");
        yield return Slot.Field(typeof(RectTransform), "m_AnchoredPosition");
        yield return Slot.Field(typeof(RectTransform), "m_SizeDelta");
        yield return Slot.Field(typeof(RectTransform), "m_Pivot");
    }

    /// <summary>Returns the Euler angles that the editor shows, rounded to 0.001° to make the text independent of the machine.</summary>
    static Vector3 EulerHint(Transform transform)
    {
        var angles = transform.localEulerAngles;
        return new Vector3(Short(angles.x), Short(angles.y), Short(angles.z));
    }

    static float Short(float degrees)
    {
        var rounded = Math.Round(degrees, 3);
        return (float)(rounded > 180 ? Math.Round(rounded - 360, 3) : rounded + 0.0);
    }

    /// <summary>
    /// Specifies a field of a component: by a name (a serialised field of the stand-in), by a name and the only allowed value, or by a slot.
    /// </summary>
    readonly struct FieldSpec(Func<Type, Slot> slotOf)
    {
        public static implicit operator FieldSpec(string name) => new FieldSpec(type => Slot.Field(type, name));

        public static implicit operator FieldSpec((string Name, string Value) only) =>
            new FieldSpec(_ => Slot.Constant(only.Name, Nodes.Text(only.Value)));

        public static implicit operator FieldSpec(Slot slot) => new FieldSpec(_ => slot);

        public Slot Of(Type type) => slotOf(type);
    }
}
