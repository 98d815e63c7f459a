using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class TextMesh : Component
{
    [SerializeField, SerializedName("m_Text")] string _text = "";
    [SerializeField, SerializedName("m_OffsetZ")] float _offsetZ;
    [SerializeField, SerializedName("m_CharacterSize")] float _characterSize = 1;
    [SerializeField, SerializedName("m_LineSpacing")] float _lineSpacing = 1;
    [SerializeField, SerializedName("m_Anchor")] TextAnchor _anchor;
    [SerializeField, SerializedName("m_Alignment")] TextAlignment _alignment;
    [SerializeField, SerializedName("m_TabSize")] float _tabSize = 4;
    [SerializeField, SerializedName("m_FontSize")] int _fontSize;
    [SerializeField, SerializedName("m_RichText")] bool _richText = true;
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

    public float characterSize
    {
        get => _characterSize;
        set => _characterSize = value;
    }

    public TextAnchor anchor
    {
        get => _anchor;
        set => _anchor = value;
    }

    public TextAlignment alignment
    {
        get => _alignment;
        set => _alignment = value;
    }

    public int fontSize
    {
        get => _fontSize;
        set => _fontSize = value;
    }

    public bool richText
    {
        get => _richText;
        set => _richText = value;
    }
}
