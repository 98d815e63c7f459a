using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Assigns the texture of its font to a text with the shader <c>Nowpose/Text</c>, even when the font replaces the texture.
    /// </summary>
    /// <remarks>
    /// The font's own material is visible through all objects and writes no depth, so the package's texts use another one. The letters are
    /// in the texture of the font's material. It is set on the text's renderer by property block, because texts of several fonts may share
    /// the text's material.
    /// </remarks>
    [AddComponentMenu("Nowpose/Font Texture")]
    [ExecuteAlways]
    [RequireComponent(typeof(TextMesh))]
    [DisallowMultipleComponent]
    public sealed class FontTexture : MonoBehaviour
    {
        static readonly int TextureId = Shader.PropertyToID("_MainTex");

        [SerializeField, Tooltip("Material of the font, an asset below the font. Its texture contains the letters. It must belong to the font of "
            + "the Text Mesh.")]
        Material _fontMaterial = null;

        Renderer _renderer;
        MaterialPropertyBlock _block;
        Texture _shown;

        // Called by the editor for a new component: the text's renderer still has the font's own material.
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
                ConsoleLog.Fail(this, ComponentMessages.NoFontMaterial(name));
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
