using UnityEngine;

namespace TMPro;

/// <summary>Text of a canvas, of which only what it says matters here.</summary>
public class TextMeshProUGUI : MonoBehaviour
{
    [SerializeField] internal string m_text = "";
    [SerializeField] internal float m_fontSize = 36;
    [SerializeField] internal float m_fontSizeBase = 36;
}
