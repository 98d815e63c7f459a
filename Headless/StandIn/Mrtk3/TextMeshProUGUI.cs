using UnityEngine;

namespace TMPro;

/// <summary>Text on a canvas. The stand-in has only its content.</summary>
public class TextMeshProUGUI : MonoBehaviour
{
    [SerializeField] internal string m_text = "";
    [SerializeField] internal float m_fontSize = 36;
    [SerializeField] internal float m_fontSizeBase = 36;
}
