using UnityEngine.Serialization;

namespace UnityEngine;

/// <summary>Stores the serialised fields of a RectTransform. Has no layout, and is internal because no script of the package uses it.</summary>
sealed class RectTransform : Transform
{
    [SerializeField, SerializedName("m_AnchorMin")] internal Vector2 _anchorMin = new(0.5f, 0.5f);
    [SerializeField, SerializedName("m_AnchorMax")] internal Vector2 _anchorMax = new(0.5f, 0.5f);
    [SerializeField, SerializedName("m_AnchoredPosition")] internal Vector2 _anchoredPosition;
    [SerializeField, SerializedName("m_SizeDelta")] internal Vector2 _sizeDelta = new(100, 100);
    [SerializeField, SerializedName("m_Pivot")] internal Vector2 _pivot = new(0.5f, 0.5f);
}
