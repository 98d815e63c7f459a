using MixedReality.Toolkit;
using Nowpose.Unity;
using Nowpose.Unity.Session;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Mrtk3
{
    /// <summary>Shows what the pairing asks, with buttons to answer: pressed, never spoken.</summary>
    /// <remarks>A word is heard where nobody said it, or said by somebody else; agreeing to a gateway takes a hand or a pinch.</remarks>
    [AddComponentMenu("Nowpose/Consent Prompt")]
    [DisallowMultipleComponent]
    public sealed class ConsentPrompt : MonoBehaviour
    {
        [SerializeField, Tooltip("What asks. Empty: the pairing on this object or above.")]
        CellPairing _pairing = null;

        [SerializeField, Tooltip("What is shown while something is asked. An object below this one.")]
        GameObject _content = null;

        [SerializeField, Tooltip("Where the question is written. Empty: nowhere, and nobody should agree to what he cannot read.")]
        TextMesh _question = null;

        [SerializeField, Tooltip("The button that agrees; its event calls Accept.")]
        StatefulInteractable _accept = null;

        [SerializeField, Tooltip("The button that declines; its event calls Refuse.")]
        StatefulInteractable _refuse = null;

        /// <summary>Maximum width of a line as a multiple of the font size, so that the question fits its ground.</summary>
        const float LineWidth = 30;

        /// <summary>Nobody reads a question faster: what is pressed before was meant for something else.</summary>
        const float ReadingSeconds = 0.5f;

        string _shown = "";
        float _shownAt;

        /// <summary>For the button that agrees; does nothing in the first half second of a question.</summary>
        public void Accept()
        {
            if (IsRead) _pairing.Accept();
        }

        /// <summary>For the button that declines; does nothing in the first half second of a question.</summary>
        public void Refuse()
        {
            if (IsRead) _pairing.Refuse();
        }

        bool IsRead => _pairing != null && _pairing.Question == _shown && Time.unscaledTime - _shownAt >= ReadingSeconds;

        void OnEnable()
        {
            if (_pairing == null) _pairing = GetComponentInParent<CellPairing>();
            if (_pairing == null) ConsoleLog.Warn(this, "consent prompt '" + name + "' has no cell pairing above it that asks; assign one");
            if (_accept != null) _accept.AllowSelectByVoice = false;
            if (_refuse != null) _refuse.AllowSelectByVoice = false;
            Show(null);
        }

        void LateUpdate()
        {
            var question = _pairing != null ? _pairing.Question : null;
            if (question != _shown) Show(question);
        }

        void Show(string question)
        {
            _shown = question;
            _shownAt = Time.unscaledTime;
            if (_question != null) _question.text = question == null ? "" : WrappedText.Of(question, LineWidth);
            if (_content != null) _content.SetActive(question != null);
        }
    }
}
