using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Gives a text whose material has the shader <c>Nowpose/Text</c> the texture of its font, also when the font replaces the texture.
    /// </summary>
    /// <remarks>
    /// The font's own material shows through everything and writes no depth, so the texts of the package have another one. Letters are
    /// in the texture of the font's material, which reaches the text's renderer by property block: the text's material may be shared by
    /// texts of several fonts.
    /// </remarks>
    [AddComponentMenu("Nowpose/Font Texture")]
    [ExecuteAlways]
    [RequireComponent(typeof(TextMesh))]
    [DisallowMultipleComponent]
    public sealed class FontTexture : MonoBehaviour
    {
        static readonly int TextureId = Shader.PropertyToID("_MainTex");

        [SerializeField, Tooltip("The font's own material, an asset below the font: its texture has the letters. It must belong to "
            + "the font of the Text Mesh.")]
        Material _fontMaterial = null;

        Renderer _renderer;
        MaterialPropertyBlock _block;
        Texture _shown;

        // Added in the editor to a new text, whose renderer has the font's own material: that one is it.
        void Reset()
        {
            var renderer = GetComponent<Renderer>();
            if (renderer != null) _fontMaterial = renderer.sharedMaterial;
        }

        void OnEnable()
        {
            _renderer = GetComponent<Renderer>();
            _shown = null;
            if (_fontMaterial == null && Application.isPlaying)
                ConsoleLog.Fail(this, "font texture '" + name + "' has no font material, so its letters are blocks; assign the one below the font");
            Apply();
        }

        void LateUpdate() => Apply();

        void Apply()
        {
            if (_fontMaterial == null || _renderer == null) return;
            var texture = _fontMaterial.mainTexture;
            if (texture == null || ReferenceEquals(texture, _shown)) return;
            _shown = texture;
            _block ??= new MaterialPropertyBlock();
            _renderer.GetPropertyBlock(_block);
            _block.SetTexture(TextureId, texture);
            _renderer.SetPropertyBlock(_block);
        }
    }
}
