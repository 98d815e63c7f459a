using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class TextMesh : Component
{
    [SerializeField, SerializedName("m_Text")] string _text = "";
    [SerializeField, SerializedName("m_OffsetZ")] float _offsetZ;
    [field: SerializeField, SerializedName("m_CharacterSize")] public float characterSize { get; set; } = 1;
    [SerializeField, SerializedName("m_LineSpacing")] float _lineSpacing = 1;
    [field: SerializeField, SerializedName("m_Anchor")] public TextAnchor anchor { get; set; }
    [field: SerializeField, SerializedName("m_Alignment")] public TextAlignment alignment { get; set; }
    [SerializeField, SerializedName("m_TabSize")] float _tabSize = 4;
    [field: SerializeField, SerializedName("m_FontSize")] public int fontSize { get; set; }
    [field: SerializeField, SerializedName("m_RichText")] public bool richText { get; set; } = true;
    [SerializeField, SerializedName("m_Color")] Color32 _color = new(255, 255, 255, 255);

    /// <summary>Number of changes of the text. In Unity, each change builds a new mesh.</summary>
    internal int TextChanges { get; private set; }

    public string text
    {
        get
        {
            ThrowIfDestroyed();
            return _text;
        }
        set
        {
            ThrowIfDestroyed();
            if (_text != value) TextChanges++;
            _text = value ?? "";
        }
    }
}

public enum TextAlignment
{
    Left = 0,
    Center = 1,
    Right = 2,
}

public enum TextAnchor
{
    UpperLeft = 0,
    UpperCenter = 1,
    UpperRight = 2,
    MiddleLeft = 3,
    MiddleCenter = 4,
    MiddleRight = 5,
    LowerLeft = 6,
    LowerCenter = 7,
    LowerRight = 8,
}
